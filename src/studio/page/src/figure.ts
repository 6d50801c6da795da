// The figure: a canvas that is moved and zoomed while the server computes detail for what is shown.
//
// Strokes come as numbers seen from a middle. While a person moves the figure the picture that was drawn last is moved; when the
// movement rests it is drawn anew, and when it rests longer the part that is shown is asked for in finer detail.

import { askBytes, askFile, askJson, Latest, Refusal } from './ask';
import { busy, colour, download, el, later, speak } from './dom';
import type { Editor } from './editor';
import { described, shownGeneration, state, change, withGeneration, type Look as Watch } from './state';
import { engine } from './engine';
import { texts } from './texts';
import type { SpaceStage } from './space';

interface Look {
  colour: string | null;
  width: number;
  length?: boolean;
}
export interface PlaneHead {
  kind: 'plane';
  generation: number;
  box: [number, number, number, number];
  empty: boolean;
  middle: [number, number];
  part: [number, number, number, number];
  segments: string;
  strokes: number;
  coarser: number;
  symbols: number;
  line_width: number;
  runs: (Look & { first: number; count: number })[];
  areas: (Look & { corners: number[]; symbol: number })[];
  rounded: string | null; // why parameters are doubles
}
export interface SpaceHead {
  kind: 'space';
  generation: number;
  empty: boolean;
  segments: string;
  box: number[];
  camera: [number, number];
  rounded: string | null;
  corners: number;
  indices: number;
  runs: { colour: string | null; first: number; count: number }[];
}
export interface Plane {
  head: PlaneHead;
  strokes: Float32Array;
  symbols: Uint32Array;
}
interface Walk {
  start: { position: number[]; heading: number[] };
  steps: { symbol: string; meaning: string; after: { position: number[]; heading: number[] }; lines: { from: number[]; to: number[]; drawn: boolean }[] }[];
}

export function planeOf(found: { head: PlaneHead; bytes: Uint8Array }): Plane {
  const count = found.head.strokes;
  return {
    head: found.head,
    strokes: new Float32Array(found.bytes.buffer, 0, 4 * count),
    symbols: new Uint32Array(found.bytes.buffer, 16 * count, count),
  };
}

export interface View {
  x: number; // of the middle of the canvas, in the units of the figure
  y: number;
  scale: number; // pixels a unit
}

/** The view in which all of a box is seen. */
export function fitted(box: readonly number[], width: number, height: number): View {
  const [x, y, wide, high] = box as [number, number, number, number];
  const margin = 0.92;
  const scale = Math.min((margin * width) / (wide || 1e-9), (margin * height) / (high || 1e-9));
  return { x: x + wide / 2, y: y + high / 2, scale: Number.isFinite(scale) && scale > 0 ? (wide === 0 && high === 0 ? 50 : scale) : 50 };
}

/** Of a line of width 1, in pixels: who sits at the back of a lecture hall sees no thinner one. */
function lineWidth(): number {
  return document.body.classList.contains('present') ? 2.2 : 1.3;
}

/** Draws the strokes of a figure. */
export function paint(context: CanvasRenderingContext2D, plane: Plane, view: View, width: number, height: number, ratio: number): void {
  const { head, strokes } = plane;
  const ink = colour('stroke');
  const dx = (head.middle[0] - view.x) * view.scale + width / 2;
  const dy = height / 2 - (head.middle[1] - view.y) * view.scale;
  const s = view.scale;
  for (const area of head.areas) {
    context.beginPath();
    for (let i = 0; i < area.corners.length; i += 2) context.lineTo(area.corners[i]! * s + dx, dy - area.corners[i + 1]! * s);
    context.closePath();
    context.fillStyle = area.colour ?? ink;
    context.fill();
  }
  context.lineCap = 'round';
  context.lineJoin = 'round';
  for (const run of head.runs) {
    context.beginPath();
    let lastX = NaN;
    let lastY = NaN;
    for (let i = 4 * run.first; i < 4 * (run.first + run.count); i += 4) {
      const x1 = strokes[i]!;
      const y1 = strokes[i + 1]!;
      if (x1 !== lastX || y1 !== lastY) context.moveTo(x1 * s + dx, dy - y1 * s);
      lastX = strokes[i + 2]!;
      lastY = strokes[i + 3]!;
      context.lineTo(lastX * s + dx, dy - lastY * s);
    }
    context.strokeStyle = run.colour ?? ink;
    context.lineWidth = run.length ? Math.max(run.width * s, 0.4) : Math.max(run.width * head.line_width * lineWidth() * ratio, 0.4);
    context.stroke();
  }
}

export class FigureTab {
  readonly root = el('div', { class: 'panel whole', role: 'tabpanel', id: 'panel-figure', 'aria-label': texts.tabs.figure });
  private readonly bar = el('div', { class: 'bar' });
  private readonly knobs = el('div', { class: 'bar' });
  private readonly stage = el('div', { class: 'stage' });
  private readonly canvas = el('canvas', { tabindex: '0', role: 'img', 'aria-label': texts.tabs.figure });
  private readonly over = el('div', { class: 'over' });
  private readonly strip = el('div', { class: 'word', hidden: true, 'aria-label': texts.words });
  private readonly n = el('input', { type: 'range', min: 0, max: 10, 'aria-label': texts.generation });
  private readonly nNumber = el('input', { type: 'number', min: 0, 'aria-label': texts.generation });
  private readonly seed = el('input', { type: 'number', min: 0, 'aria-label': texts.seed });
  private readonly seedLabel = el('label', {}, texts.seed, this.seed);
  private readonly playButton = el('button', { 'aria-pressed': 'false', onclick: () => void this.play() }, '▶ ' + texts.play);
  private readonly walkButton = el('button', { 'aria-pressed': 'false', title: texts.walkHelp, onclick: () => void this.toggleWalk() }, texts.walk);
  private readonly step = el('input', { type: 'range', min: 0, value: 0, 'aria-label': texts.stepOfTurtle });
  private readonly stepSaid = el('span', {});
  private readonly stepBar = el('div', { class: 'bar', hidden: true }, el('label', {}, texts.step, this.step), this.stepSaid);
  private readonly exports = el('select', { 'aria-label': texts.export });
  private readonly latest = new Latest();
  private readonly finer = new Latest();
  private whole: Plane | null = null;
  private part: Plane | null = null;
  private view: View | null = null;
  private picture: { canvas: HTMLCanvasElement; view: View } | null = null;
  private walk: Walk | null = null;
  private playing = false;
  private union: number[] | null = null;
  private shownKey = '';
  private settle = 0;
  private wanted: Watch | null = null; // how a link looks at the figure that is not there yet
  private waits: (() => void) | null = null;
  private space: SpaceStage | null = null;
  visible = false;
  private stale = false; // drawn in colours of before
  /** When the picture of the last change was on the screen, for measurements. */
  painted = 0;

  constructor(private readonly editor: Editor) {
    this.bar.append(
      el('label', {}, 'n', this.n, this.nNumber),
      this.playButton,
      this.walkButton,
      el('button', { title: '0', onclick: () => this.fit() }, texts.fit),
      el('button', { 'aria-label': texts.zoomIn, onclick: () => this.zoom(1.5) }, '+'),
      el('button', { 'aria-label': texts.zoomOut, onclick: () => this.zoom(1 / 1.5) }, '−'),
      this.seedLabel,
      this.exports,
    );
    this.stage.append(this.canvas, this.over);
    this.root.append(this.bar, this.knobs, this.stage, this.stepBar, this.strip);
    this.n.addEventListener('input', () => change({ n: Number(this.n.value) }));
    this.nNumber.addEventListener('change', () => change({ n: Math.max(0, Math.floor(Number(this.nNumber.value))) }));
    this.seed.addEventListener('input', () => change({ seed: Math.max(0, Math.floor(Number(this.seed.value))) }));
    this.step.addEventListener('input', () => this.showStep());
    this.exports.addEventListener('change', () => void this.export());
    const lack = engine.lacks('picture');
    if (lack) Object.assign(this.exports, { disabled: true, title: lack });
    new ResizeObserver(() => this.resize()).observe(this.stage);
    this.listenToPointers();
    this.canvas.addEventListener('keydown', (event) => this.key(event));
  }

  /** How the figure is looked at, for links. */
  look(): Watch {
    const look: Watch = {};
    if (this.space) look.camera = this.space.place();
    else if (this.view && this.canvas.clientWidth > 0) look.view = [this.view.x, this.view.y, this.canvas.clientWidth / this.view.scale];
    if (this.walk) look.step = Number(this.step.value);
    return look;
  }

  /** Looks so at the figure that comes next. */
  lookAt(look: Watch): void {
    this.wanted = look;
    this.shownKey = '';
  }

  /** What a link wants of the figure that has come. */
  private async obey(signal: AbortSignal): Promise<void> {
    const wanted = this.wanted;
    this.wanted = null;
    if (wanted?.camera) this.space?.stand(wanted.camera);
    if (wanted?.view && this.whole && this.canvas.clientWidth > 0) {
      const [x, y, wide] = wanted.view as [number, number, number];
      this.view = { x, y, scale: this.canvas.clientWidth / wide };
      this.moved();
      this.draw();
    }
    if (wanted?.step !== undefined && !this.space) {
      await this.loadWalk(signal);
      this.step.value = String(wanted.step);
      this.showStep();
    }
  }

  /** The system, the generation or the view changed. */
  async update(): Promise<void> {
    if (!this.visible) return;
    if (described()) this.controls();
    const key = JSON.stringify([state.system, state.n, state.seed]);
    if (key === this.shownKey) {
      if (this.stale) this.repaint();
      return;
    }
    this.shownKey = key;
    const wait = setTimeout(() => this.say(texts.working, 'wait'), 150);
    try {
      await this.latest.run(async (signal) => {
        const found = await askBytes<PlaneHead | SpaceHead>(withGeneration('figure', { pixels: this.pixels() }), { signal });
        if (signal.aborted) return;
        if (found.head.kind === 'space') await this.showSpace(found.head, found.bytes);
        else this.showPlane(planeOf(found as { head: PlaneHead; bytes: Uint8Array }));
        if (this.walk && !this.playing) await this.loadWalk(signal);
        await this.obey(signal);
      });
    } catch (error) {
      this.fail(error);
    } finally {
      clearTimeout(wait);
    }
  }

  private fail(error: unknown): void {
    // What is wrong with the text is said beside the text.
    if (error instanceof Refusal && error.line !== null && (this.whole || this.space)) return this.say(texts.noSystem);
    this.say(error instanceof Error ? error.message : String(error), error instanceof Refusal && error.isBound ? 'wait' : 'bad');
  }

  private say(text: string, kind = 'note'): void {
    this.over.textContent = text;
    this.over.className = `over ${kind}`;
  }

  private pixels(): number {
    return Math.round(Math.max(this.canvas.clientWidth, this.canvas.clientHeight, 300) * devicePixelRatio);
  }

  private controls(): void {
    const about = described()!;
    const n = shownGeneration();
    const shown = about.generations?.[1] ?? 3;
    this.n.max = String(Math.max(shown + 3, 8, n));
    this.n.value = this.nNumber.value = String(n);
    this.seedLabel.hidden = !about.chance && !about.seeds;
    this.seed.value = String(state.seed ?? about.seeds?.[0] ?? 1);
    const formats = about.space ? ['svg', 'pdf', 'png', 'glb', 'stl', 'obj', 'x3d'] : ['svg', 'pdf', 'png', 'tex', 'html', 'gif', 'dxf', 'geojson', 'csv'];
    const names: Record<string, string> = { tex: 'TikZ' };
    if (this.exports.dataset['for'] !== formats.join()) {
      this.exports.dataset['for'] = formats.join();
      this.exports.replaceChildren(el('option', { value: '' }, texts.export + '…'), ...formats.map((format) => el('option', { value: format }, names[format] ?? format.toUpperCase())));
    }
    this.walkButton.disabled = about.space || about.shape;
    // A slider for the angle and for each constant; they write into the text, where everybody sees it.
    const wanted = JSON.stringify([about.constants.map((one) => one.name), about.angle !== null]);
    if (this.knobs.dataset['for'] !== wanted) {
      this.knobs.dataset['for'] = wanted;
      this.knobs.replaceChildren();
      const numeric = (written: string): boolean => /^-?\d+(\.\d+)?$/.test(written);
      if (about.angle && numeric(about.angle.written))
        this.knobs.append(this.knob(texts.angle, about.angle.value, [-180, 180, 0.5], (value) => this.editor.replaceMatch(/(^|[;{\n])\s*angle\s+(-?\d+(?:\.\d+)?)/, value)));
      for (const one of about.constants)
        if (numeric(one.written)) {
          const name = one.name.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
          const reach = Math.max(Math.abs(one.value) * 2, 1);
          const stepsize = Math.abs(one.value) >= 10 ? 0.5 : 0.01;
          this.knobs.append(
            this.knob(one.name, one.value, [one.value < 0 ? -reach : 0, reach, stepsize], (value) => this.editor.replaceMatch(new RegExp(`(^|[;{\\n])\\s*let\\s+${name}\\s*=\\s*(-?\\d+(?:\\.\\d+)?)`), value)),
          );
        }
      this.knobs.hidden = this.knobs.childElementCount === 0;
    }
    for (const input of this.knobs.querySelectorAll('input')) {
      const name = input.dataset['name'];
      const value = name === texts.angle ? about.angle?.value : about.constants.find((one) => one.name === name)?.value;
      if (value !== undefined && document.activeElement !== input) {
        input.value = String(value);
        (input.nextSibling as HTMLElement).textContent = String(value);
      }
    }
  }

  private knob(name: string, value: number, [low, high, step]: [number, number, number], set: (value: string) => void): HTMLElement {
    const said = el('output', {}, String(value));
    const input = el('input', { type: 'range', min: low, max: high, step, value, 'aria-label': name, 'data-name': name });
    input.addEventListener('input', () => {
      said.textContent = input.value;
      set(input.value);
    });
    return el('label', {}, name, input, said);
  }

  // The plane

  private showPlane(plane: Plane): void {
    if (this.space) {
      this.space.dispose();
      this.space = null;
      this.canvas.hidden = false;
    }
    const before = this.whole;
    this.whole = plane;
    this.part = null;
    const isNew = !before || before.head.generation !== plane.head.generation || JSON.stringify(before.head.box) !== JSON.stringify(plane.head.box);
    if (!this.view || isNew) this.view = fitted(this.union ?? plane.head.box, this.canvas.clientWidth, this.canvas.clientHeight);
    this.draw();
    this.facts();
    this.seen();
  }

  private facts(): void {
    const head = this.whole?.head;
    if (!head) return;
    if (head.empty) {
      this.canvas.setAttribute('aria-label', texts.noFigure);
      return this.say(texts.noFigure);
    }
    let said = segmentsOf(head);
    if (BigInt(head.segments) > BigInt(head.strokes) * 2n) said += ` · ${texts.coarse}`;
    if (head.rounded) said += ` · ${texts.rounded(head.rounded)}`;
    this.say(`n = ${head.generation} · ${said}`);
    this.canvas.setAttribute('aria-label', texts.figureOf(head.generation, said));
  }

  private resize(): void {
    if (!this.visible || this.canvas.clientWidth === 0) return;
    const wide = Math.round(this.canvas.clientWidth * devicePixelRatio);
    const high = Math.round(this.canvas.clientHeight * devicePixelRatio);
    if (this.canvas.width === wide && this.canvas.height === high) return;
    this.canvas.width = wide;
    this.canvas.height = high;
    this.space?.resize();
    if (this.whole) {
      this.view = fitted(this.union ?? this.whole.head.box, this.canvas.clientWidth, this.canvas.clientHeight);
      this.draw();
    }
  }

  private draw(): void {
    if (!this.view || !this.whole || this.space) return;
    const ratio = devicePixelRatio;
    const wide = Math.round(this.canvas.clientWidth * ratio);
    const high = Math.round(this.canvas.clientHeight * ratio);
    if (wide === 0) return;
    if (this.canvas.width !== wide || this.canvas.height !== high) {
      this.canvas.width = wide;
      this.canvas.height = high;
    }
    const picture = document.createElement('canvas');
    picture.width = wide;
    picture.height = high;
    const context = picture.getContext('2d')!;
    const view = { ...this.view, scale: this.view.scale * ratio };
    const shown = this.part && this.covers(this.part) ? this.part : this.whole;
    if (this.walk) this.paintWalk(context, view, wide, high, ratio);
    else paint(context, shown, view, wide, high, ratio);
    this.picture = { canvas: picture, view: { ...this.view } };
    this.copy();
  }

  private covers(plane: Plane): boolean {
    const view = this.view!;
    const [x, y, wide, high] = plane.head.part;
    const halfWide = this.canvas.clientWidth / view.scale / 2;
    const halfHigh = this.canvas.clientHeight / view.scale / 2;
    const slack = 1e-6 * (wide + high);
    return view.x - halfWide >= x - slack && view.x + halfWide <= x + wide + slack && view.y - halfHigh >= y - slack && view.y + halfHigh <= y + high + slack;
  }

  /** Shows the picture that was drawn last where the view is now. */
  private copy(): void {
    if (!this.picture || !this.view) return;
    const ratio = devicePixelRatio;
    const context = this.canvas.getContext('2d')!;
    const { canvas, view } = this.picture;
    const zoom = this.view.scale / view.scale;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    const dx = (view.x - this.view.x) * this.view.scale * ratio + (canvas.width / 2) * (1 - zoom);
    const dy = (this.view.y - view.y) * this.view.scale * ratio + (canvas.height / 2) * (1 - zoom);
    context.setTransform(zoom, 0, 0, zoom, dx, dy);
    context.drawImage(canvas, 0, 0);
  }

  private moved(): void {
    this.copy();
    clearTimeout(this.settle);
    this.waits?.();
    this.waits = busy('right');
    this.settle = window.setTimeout(() => {
      this.draw();
      this.settle = window.setTimeout(() => {
        void this.refine();
        this.waits?.();
      }, 150);
    }, 60);
  }

  /** Asks for the part that is shown, and a margin around it, in the detail of the screen. */
  private async refine(): Promise<void> {
    if (!this.whole || !this.view || this.walk || this.space) return;
    const whole = this.whole.head;
    const wide = (1.5 * this.canvas.clientWidth) / this.view.scale;
    const high = (1.5 * this.canvas.clientHeight) / this.view.scale;
    // What is there already is fine enough if the figure is seen as a whole, or if it is all there.
    if (wide > 1.3 * whole.box[2] && high > 1.3 * whole.box[3]) return;
    if (whole.coarser === 1 && BigInt(whole.segments) === BigInt(whole.strokes)) return;
    const part = [this.view.x - wide / 2, this.view.y - high / 2, wide, high];
    const key = this.shownKey;
    const wait = setTimeout(() => this.say(texts.working, 'wait'), 250);
    try {
      const found = await this.finer.run((signal) => askBytes<PlaneHead>(withGeneration('figure', { part, pixels: Math.round(1.5 * this.pixels()) }), { signal }));
      if (!found || key !== this.shownKey) return;
      this.part = planeOf(found);
      this.draw();
      this.facts();
    } catch (error) {
      this.fail(error);
    } finally {
      clearTimeout(wait);
    }
  }

  fit(): void {
    if (this.space) return this.space.home();
    if (!this.whole) return;
    this.view = fitted(this.whole.head.box, this.canvas.clientWidth, this.canvas.clientHeight);
    this.part = null;
    this.draw();
  }

  zoom(factor: number, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2): void {
    if (this.space) return this.space.zoom(factor);
    const view = this.view;
    if (!view) return;
    const dx = x - this.canvas.clientWidth / 2;
    const dy = this.canvas.clientHeight / 2 - y;
    view.x += (dx / view.scale) * (1 - 1 / factor);
    view.y += (dy / view.scale) * (1 - 1 / factor);
    view.scale *= factor;
    this.moved();
  }

  private listenToPointers(): void {
    const down = new Map<number, { x: number; y: number }>();
    let distance = 0;
    let travelled = 0;
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      distance = 0;
      travelled = 0;
    });
    this.canvas.addEventListener('pointermove', (event) => {
      const from = down.get(event.pointerId);
      if (!from || !this.view) return;
      travelled += Math.abs(event.offsetX - from.x) + Math.abs(event.offsetY - from.y);
      if (down.size === 1) {
        this.view.x -= (event.offsetX - from.x) / this.view.scale;
        this.view.y += (event.offsetY - from.y) / this.view.scale;
      }
      down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      if (down.size === 2) {
        const [a, b] = [...down.values()] as [{ x: number; y: number }, { x: number; y: number }];
        const now = Math.hypot(a.x - b.x, a.y - b.y);
        if (distance > 0) this.zoom(now / distance, (a.x + b.x) / 2, (a.y + b.y) / 2);
        distance = now;
      }
      this.moved();
    });
    const up = (event: PointerEvent): void => {
      if (down.delete(event.pointerId) && travelled < 4) this.choose(event.offsetX, event.offsetY);
    };
    this.canvas.addEventListener('pointerup', up);
    this.canvas.addEventListener('pointercancel', (event) => down.delete(event.pointerId));
    this.canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY * 0.0016), event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    this.canvas.addEventListener('dblclick', (event) => this.zoom(2, event.offsetX, event.offsetY));
  }

  /** The keys of the figure; also those of the presentation. */
  key(event: KeyboardEvent): boolean {
    const pan = 60 / (this.view?.scale ?? 1);
    const forward = (by: number): void => {
      if (this.walk) {
        this.step.value = String(Number(this.step.value) + by);
        this.showStep();
      } else change({ n: Math.max(0, shownGeneration() + by) });
    };
    const move = (x: number, y: number): void => {
      if (!this.view || this.space) return;
      this.view.x += x;
      this.view.y += y;
      this.moved();
    };
    const keys: Record<string, () => void> = {
      '+': () => this.zoom(1.3),
      '=': () => this.zoom(1.3),
      '-': () => this.zoom(1 / 1.3),
      '0': () => this.fit(),
      ArrowRight: () => (event.shiftKey ? move(pan, 0) : forward(1)),
      ArrowLeft: () => (event.shiftKey ? move(-pan, 0) : forward(-1)),
      PageDown: () => forward(1),
      PageUp: () => forward(-1),
      ArrowUp: () => move(0, pan),
      ArrowDown: () => move(0, -pan),
      ' ': () => void this.play(),
    };
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return false;
    event.preventDefault();
    action();
    return true;
  }

  // Growth as a film

  async play(): Promise<void> {
    if (this.playing) {
      this.playing = false;
      return;
    }
    const about = described();
    if (!about) return;
    const last = shownGeneration();
    this.playing = true;
    this.playButton.textContent = '❚❚ ' + texts.pause;
    this.playButton.setAttribute('aria-pressed', 'true');
    try {
      const frames: { head: PlaneHead | SpaceHead; bytes: Uint8Array }[] = [];
      for (let n = 0; n <= last && this.playing; ++n) frames.push(await askBytes<PlaneHead | SpaceHead>({ ...withGeneration('figure', { pixels: this.pixels() }), n }));
      // One frame around all, unless the figures are of very different sizes anyway.
      const planes = frames.map((frame) => frame.head).filter((head): head is PlaneHead => head.kind === 'plane' && !head.empty);
      if (planes.length > 0) {
        const low = [Math.min(...planes.map((one) => one.box[0])), Math.min(...planes.map((one) => one.box[1]))] as const;
        const high = [Math.max(...planes.map((one) => one.box[0] + one.box[2])), Math.max(...planes.map((one) => one.box[1] + one.box[3]))] as const;
        this.union = [low[0], low[1], high[0] - low[0], high[1] - low[1]];
      }
      this.view = null;
      for (const frame of frames) {
        if (!this.playing) break;
        if (frame.head.kind === 'space') await this.showSpace(frame.head, frame.bytes);
        else this.showPlane(planeOf(frame as { head: PlaneHead; bytes: Uint8Array }));
        this.n.value = this.nNumber.value = String(frame.head.generation);
        speak(`${texts.generation} ${frame.head.generation}`);
        await later(650);
      }
    } catch (error) {
      this.fail(error);
    } finally {
      this.playing = false;
      this.union = null;
      this.playButton.textContent = '▶ ' + texts.play;
      this.playButton.setAttribute('aria-pressed', 'false');
      this.shownKey = '';
      void this.update();
    }
  }

  // The turtle, step by step

  private async toggleWalk(): Promise<void> {
    if (this.walk) {
      this.endWalk();
      this.draw();
      return;
    }
    try {
      await this.latest.run((signal) => this.loadWalk(signal));
    } catch (error) {
      this.fail(error);
      speak(this.over.textContent ?? '');
    }
  }

  private endWalk(): void {
    this.walk = null;
    this.stepBar.hidden = this.strip.hidden = true;
    this.walkButton.setAttribute('aria-pressed', 'false');
  }

  private async loadWalk(signal: AbortSignal): Promise<void> {
    try {
      const before = this.walk ? Number(this.step.value) : null;
      const walk = await askJson<Walk>(withGeneration('walk'), { signal });
      if (signal.aborted) return;
      this.walk = walk;
      this.walkButton.setAttribute('aria-pressed', 'true');
      this.step.max = String(walk.steps.length);
      this.step.value = String(Math.min(before ?? walk.steps.length, walk.steps.length));
      this.stepBar.hidden = this.strip.hidden = false;
      const most = 4000;
      this.strip.replaceChildren(
        ...walk.steps.slice(0, most).map((step, i) =>
          el(
            'span',
            {
              onclick: () => {
                this.step.value = String(i + 1);
                this.showStep();
              },
            },
            step.symbol,
          ),
        ),
        walk.steps.length > most ? texts.more(walk.steps.length - most) : '',
      );
      this.showStep();
    } catch (error) {
      this.endWalk();
      throw error;
    }
  }

  private showStep(): void {
    const walk = this.walk;
    if (!walk) return;
    const k = Number(this.step.value);
    const now = walk.steps[k - 1];
    this.stepSaid.textContent = texts.stepSaid(now ? k : 0, walk.steps.length, now ? `: ${now.symbol}, ${now.meaning}` : '');
    this.stepSaid.setAttribute('aria-live', 'polite');
    const spans = this.strip.children;
    for (let i = 0; i < spans.length; ++i) spans[i]!.className = i === k - 1 ? 'now' : i < k - 1 ? 'past' : '';
    spans[Math.max(0, k - 1)]?.scrollIntoView({ block: 'nearest' });
    this.draw();
  }

  private paintWalk(context: CanvasRenderingContext2D, view: View, wide: number, high: number, ratio: number): void {
    const walk = this.walk!;
    const k = Number(this.step.value);
    const x = (at: number[]): number => (at[0]! - view.x) * view.scale + wide / 2;
    const y = (at: number[]): number => high / 2 - (at[1]! - view.y) * view.scale;
    const lines = (from: number, to: number, style: string, width: number): void => {
      context.beginPath();
      for (const step of walk.steps.slice(from, to))
        for (const line of step.lines)
          if (line.drawn) {
            context.moveTo(x(line.from), y(line.from));
            context.lineTo(x(line.to), y(line.to));
          }
      context.strokeStyle = style;
      context.lineWidth = width * ratio;
      context.stroke();
    };
    context.lineCap = 'round';
    context.globalAlpha = 0.45;
    lines(k, walk.steps.length, colour('quiet'), 1);
    context.globalAlpha = 1;
    lines(0, k, colour('stroke'), 2.2);
    if (k > 0) lines(k - 1, k, colour('focus'), 3.5);
    // The turtle: an arrowhead where it is, with its heading.
    const at = k > 0 ? walk.steps[k - 1]!.after : walk.start;
    const size = 11 * ratio;
    const length = Math.hypot(at.heading[0]!, at.heading[1]!) || 1;
    const [hx, hy] = [at.heading[0]! / length, -at.heading[1]! / length];
    context.beginPath();
    context.moveTo(x(at.position) + hx * size, y(at.position) + hy * size);
    context.lineTo(x(at.position) - hx * size * 0.7 - hy * size * 0.75, y(at.position) - hy * size * 0.7 + hx * size * 0.75);
    context.lineTo(x(at.position) - hx * size * 0.3, y(at.position) - hy * size * 0.3);
    context.lineTo(x(at.position) - hx * size * 0.7 + hy * size * 0.75, y(at.position) - hy * size * 0.7 - hx * size * 0.75);
    context.closePath();
    context.fillStyle = colour('accent');
    context.strokeStyle = colour('paper');
    context.lineWidth = 1.5 * ratio;
    context.fill();
    context.stroke();
  }

  /** The symbol of the word that drew what is at this place of the canvas. */
  private choose(px: number, py: number): void {
    const view = this.view;
    const walk = this.walk;
    if (!view || !walk) return;
    const x = view.x + (px - this.canvas.clientWidth / 2) / view.scale;
    const y = view.y + (this.canvas.clientHeight / 2 - py) / view.scale;
    let best = 10 / view.scale;
    let chosen = -1;
    walk.steps.forEach((step, i) => {
      for (const line of step.lines) {
        if (!line.drawn) continue;
        const [ax, ay] = [line.from[0]!, line.from[1]!];
        const [dx, dy] = [line.to[0]! - ax, line.to[1]! - ay];
        const along = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
        const far = Math.hypot(x - ax - along * dx, y - ay - along * dy);
        if (far < best) {
          best = far;
          chosen = i;
        }
      }
    });
    if (chosen < 0) return;
    this.step.value = String(chosen + 1);
    this.showStep();
  }

  // Space

  private async showSpace(head: SpaceHead, bytes: Uint8Array): Promise<void> {
    this.endWalk();
    this.whole = this.part = null;
    if (!this.space) {
      const { SpaceStage } = await import('./space');
      try {
        this.space = new SpaceStage(this.stage);
      } catch {
        return this.say(texts.noWebGL, 'bad');
      }
      this.canvas.hidden = true;
    }
    this.space.show(head, bytes);
    this.say(head.empty ? texts.noFigure : `n = ${head.generation} · ${segmentsOf(head)}${head.rounded ? ` · ${texts.rounded(head.rounded)}` : ''}`);
    this.seen();
  }

  /** A frame with the picture has been made when a message arrives that was sent in it. */
  private seen(): void {
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => (this.painted = performance.now());
      port2.postMessage(0);
    });
  }

  /** In the colours of now; where the figure is not seen, as soon as it is. */
  repaint(): void {
    this.stale = this.canvas.clientWidth === 0 && !this.space;
    if (!this.stale) this.draw();
    this.space?.repaint();
  }

  private async export(): Promise<void> {
    const format = this.exports.value;
    this.exports.value = '';
    if (!format) return;
    this.say(texts.working, 'wait');
    try {
      const question = withGeneration('picture', { format });
      const bytes = await askFile(question);
      download(bytes, `${state.file.replace(/\.\w+$/, '') || 'figure'}.${format}`);
      this.facts();
    } catch (error) {
      this.fail(error);
    }
  }
}

function segmentsOf(head: { segments: string }): string {
  return texts.segments(group(head.segments), Number(head.segments));
}

export function group(digits: string): string {
  return digits.replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
}
