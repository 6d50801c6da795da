// A figure in space, which one turns. The server sends its triangles.

import { AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, Mesh, MeshLambertMaterial, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { colour } from './dom';
import { texts } from './texts';
import type { SpaceHead } from './figure';

export class SpaceStage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(40, 1, 0.01, 1000);
  private readonly controls: OrbitControls;
  private readonly light = new DirectionalLight(0xffffff, 2.4);
  private figure: Group | null = null;
  private radius = 1;
  private from: [number, number] = [-60, 15];
  private places = new Float32Array(0);
  private isFirst = true;

  constructor(private readonly parent: HTMLElement) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(devicePixelRatio);
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', texts.figureInSpace);
    parent.prepend(canvas);
    this.camera.up.set(0, 0, 1);
    this.scene.add(new AmbientLight(0xffffff, 1.1), this.light, this.camera);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.repaint());
    this.controls.keyPanSpeed = 20;
    this.controls.listenToKeyEvents(canvas);
    this.resize();
  }

  show(head: SpaceHead, bytes: Uint8Array): void {
    if (this.figure) {
      this.scene.remove(this.figure);
      this.figure.traverse((part) => {
        if (part instanceof Mesh) {
          (part.geometry as BufferGeometry).dispose();
          (part.material as MeshLambertMaterial).dispose();
        }
      });
    }
    this.figure = new Group();
    this.places = new Float32Array(0);
    if (!head.empty) {
      const corners = new Float32Array(bytes.buffer, bytes.byteOffset, 6 * head.corners);
      const indices = new Uint32Array(bytes.buffer, bytes.byteOffset + 24 * head.corners, head.indices);
      const places = (this.places = new Float32Array(3 * head.corners));
      const normals = new Float32Array(3 * head.corners);
      for (let i = 0; i < head.corners; ++i)
        for (let k = 0; k < 3; ++k) {
          places[3 * i + k] = corners[6 * i + k]!;
          normals[3 * i + k] = corners[6 * i + 3 + k]!;
        }
      const place = new BufferAttribute(places, 3);
      const normal = new BufferAttribute(normals, 3);
      for (const run of head.runs) {
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', place);
        geometry.setAttribute('normal', normal);
        geometry.setIndex(new BufferAttribute(indices.subarray(run.first, run.first + run.count), 1));
        geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
        this.figure.add(new Mesh(geometry, new MeshLambertMaterial({ color: new Color(run.colour ?? '#5b8f5f'), side: DoubleSide })));
      }
    }
    this.scene.add(this.figure);
    const [x0, y0, z0, x1, y1, z1] = head.box as [number, number, number, number, number, number];
    this.radius = Math.max(Math.hypot(x1 - x0, y1 - y0, z1 - z0) / 2, 1e-9);
    this.from = head.camera;
    this.camera.near = this.radius / 1000;
    this.camera.far = this.radius * 100;
    if (this.isFirst) this.home();
    else {
      this.camera.updateProjectionMatrix();
      this.controls.maxDistance = this.radius * 40;
      const away = this.camera.position.length();
      if (away < this.radius * 0.5 || away > this.radius * 8) this.home();
    }
    this.isFirst = false;
    this.repaint();
  }

  /** Where the system's own camera stands, all in view. */
  home(): void {
    const [azimuth, elevation] = this.from.map((degrees) => (degrees * Math.PI) / 180) as [number, number];
    const back = new Vector3(Math.cos(azimuth) * Math.cos(elevation), Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation));
    const right = new Vector3(-Math.sin(azimuth), Math.cos(azimuth), 0);
    const up = new Vector3().crossVectors(back, right);
    // As near as every corner allows: one that lies z nearer and x to the side is seen from z + |x| / tan(half the angle of view) on.
    const steep = Math.tan((this.camera.fov * Math.PI) / 360);
    let distance = this.radius / 100;
    for (let i = 0; i + 2 < this.places.length; i += 3) {
      const [x, y, z] = [this.places[i]!, this.places[i + 1]!, this.places[i + 2]!];
      const side = Math.abs(x * right.x + y * right.y + z * right.z) / (steep * this.camera.aspect);
      const high = Math.abs(x * up.x + y * up.y + z * up.z) / steep;
      distance = Math.max(distance, x * back.x + y * back.y + z * back.z + Math.max(side, high));
    }
    this.camera.position.copy(back.multiplyScalar(1.06 * distance));
    this.controls.target.set(0, 0, 0);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.repaint();
  }

  /** Where the camera stands and what it looks at. */
  place(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  stand([x, y, z, a, b, c]: number[]): void {
    this.camera.position.set(x!, y!, z!);
    this.controls.target.set(a!, b!, c!);
    this.controls.update();
    this.repaint();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.controls.update();
    this.repaint();
  }

  resize(): void {
    const { clientWidth: wide, clientHeight: high } = this.parent;
    if (wide === 0 || high === 0) return;
    this.renderer.setSize(wide, high);
    this.camera.aspect = wide / high;
    this.camera.updateProjectionMatrix();
    this.repaint();
  }

  repaint(): void {
    this.renderer.setClearColor(new Color(colour('paper')), 1);
    // The light stands over the viewer's left shoulder.
    const left = new Vector3(-0.6, 0.5, 0.6).applyQuaternion(this.camera.quaternion);
    this.light.position.copy(left.multiplyScalar(this.radius * 4));
    this.renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }
}
