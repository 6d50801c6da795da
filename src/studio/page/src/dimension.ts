// Dimension: the exact one, and the boxes that measure it, which one sees over the figure at each scale.

import { askBytes, askJson, Latest, Refusal } from './ask';
import { colour, el, speak } from './dom';
import { paint, planeOf, type Plane } from './figure';
import { plot } from './plot';
import { described, state, systemQuestion, withGeneration } from './state';
import { texts } from './texts';

interface Dimension {
  input: string;
  exact?: { status: string; almost_surely?: boolean; formula?: string; value?: number; decimal?: string; conditions?: string[]; because?: string; reason?: string };
  box: {
    value: number | null;
    low: number | null;
    high: number | null;
    because: string;
    scales: { cell: number; cells: number; least: number; most: number; used: boolean }[];
  };
}

export class DimensionTab {
  readonly root = el('div', { class: 'panel', role: 'tabpanel', id: 'panel-dimension', tabindex: '0', 'aria-label': texts.tabs.dimension });
  private readonly latest = new Latest();
  private shownKey = '';
  private canvas: HTMLCanvasElement | null = null;
  private plane: Plane | null = null;
  private side = 0; // how many boxes lie side by side
  visible = false;

  /** Measuring takes long: it ends when its system is no longer there. */
  forget(): void {
    this.latest.stop();
  }

  async update(): Promise<void> {
    const about = described();
    if (!this.visible || !about) return;
    const key = JSON.stringify([state.system, state.seed]);
    if (key === this.shownKey) return this.draw(); // in the colours of now
    const wait = setTimeout(() => this.root.replaceChildren(el('p', { class: 'wait' }, texts.measuring)), 150);
    try {
      await this.latest.run(async (signal) => {
        const found = await askJson<Dimension>(systemQuestion('dimension'), { signal }, [0, 1, 3]);
        clearTimeout(wait);
        if (signal.aborted) return;
        this.shownKey = key;
        this.plane = null;
        if (!about.space) {
          const figure = await askBytes<{ kind: string }>(withGeneration('figure', { pixels: 900 }), { signal });
          if (figure.head.kind === 'plane') this.plane = planeOf(figure as never);
        }
        this.show(found);
      });
    } catch (error) {
      this.root.replaceChildren(el('p', { class: error instanceof Refusal && error.isBound ? 'wait' : 'bad' }, error instanceof Error ? error.message : String(error)));
    } finally {
      clearTimeout(wait);
    }
  }

  private show(found: Dimension): void {
    const exact = found.exact;
    const head = el('div', {});
    if (exact?.formula) {
      head.append(el('p', { class: 'result' }, `${texts.exact}: `, el('b', {}, `${exact.formula} = ${exact.decimal?.slice(0, 14) ?? exact.value}`), exact.status === 'exact' ? '' : ` (${exact.status})`, exact.almost_surely ? `, ${texts.almostSurely}` : ''));
      for (const condition of exact.conditions ?? []) head.append(el('p', { class: 'note' }, condition));
    } else if (exact) {
      head.append(el('p', { class: 'note' }, `${texts.exact}: ${exact.because ?? exact.reason ?? exact.status}`));
    }
    const box = found.box;
    head.append(
      el('p', {}, `${texts.measured}: `, box.value === null ? el('span', { class: 'wait' }, box.because) : el('b', {}, `${box.value.toFixed(4)} (${box.low?.toFixed(4)} … ${box.high?.toFixed(4)})`)),
      el('p', { class: 'note' }, found.input.replace('standard input', texts.system)),
    );
    const scales = box.scales.filter((scale) => scale.cells > 0);
    if (scales.length < 2) return this.root.replaceChildren(head);
    // Sides of boxes are in the units of the figure; those of a limit are parts of its size.
    const first = scales[0]!;
    const size = this.plane && !/limit/.test(found.input) ? Math.max(this.plane.head.box[2], this.plane.head.box[3]) : 1;
    const sides = scales.map((scale) => Math.max(1, size / scale.cell));
    const dots = scales.map((scale) => ({
      x: Math.log10(first.cell / scale.cell),
      y: Math.log10(scale.cells),
      used: scale.used,
      said: texts.boxesSaid(scale.cell.toPrecision(4), Number(scale.cells.toFixed(1)), scale.least, scale.most, scale.used),
    }));
    const used = dots.filter((dot) => dot.used);
    const line: [number, number][] = [];
    if (box.value !== null && used.length > 1) {
      const meanX = used.reduce((sum, dot) => sum + dot.x, 0) / used.length;
      const meanY = used.reduce((sum, dot) => sum + dot.y, 0) / used.length;
      for (const x of [dots[0]!.x, dots[dots.length - 1]!.x]) line.push([x, meanY + box.value * (x - meanX)]);
    }
    const said = el('p', { class: 'note', 'aria-live': 'polite' }, texts.touch);
    const canvas = el('canvas', { class: 'boxes', role: 'img', 'aria-label': texts.figureWithBoxes });
    this.canvas = canvas;
    const picture = plot({
      horizontal: texts.boxSides,
      vertical: texts.boxesMet,
      logarithmic: true,
      logarithmicX: true,
      dots,
      line,
      chosen: (index) => {
        this.side = sides[index]!;
        said.textContent = dots[index]!.said;
        speak(dots[index]!.said);
        this.draw();
      },
    });
    this.root.replaceChildren(head, el('div', { class: 'columns' }, el('div', { class: 'measured' }, picture as unknown as HTMLElement, said), this.plane ? canvas : null));
    this.side = 0;
    this.draw();
  }

  repaint(): void {
    this.draw();
  }

  /** The figure, and the boxes of the chosen scale that meet it. */
  private draw(): void {
    const { canvas, plane } = this;
    if (!canvas || !plane || canvas.clientWidth === 0) return;
    const ratio = devicePixelRatio;
    const wide = (canvas.width = Math.round(canvas.clientWidth * ratio));
    const high = (canvas.height = Math.round(canvas.clientHeight * ratio));
    const context = canvas.getContext('2d')!;
    const [x0, y0, breadth, height] = plane.head.box;
    const size = Math.max(breadth, height) || 1;
    const scale = (0.92 * Math.min(wide, high)) / size;
    const view = { x: x0 + breadth / 2, y: y0 + height / 2, scale };
    if (this.side > 0) {
      const cell = size / this.side;
      const cells = new Set<number>();
      const columns = Math.ceil(this.side) + 3;
      const { strokes, head } = plane;
      const put = (x: number, y: number): void => {
        cells.add(Math.floor((y - y0) / cell + 1) * columns + Math.floor((x - x0) / cell + 1));
      };
      for (let i = 0; i < strokes.length; i += 4) {
        const ax = strokes[i]! + head.middle[0];
        const ay = strokes[i + 1]! + head.middle[1];
        const dx = strokes[i + 2]! - strokes[i]!;
        const dy = strokes[i + 3]! - strokes[i + 1]!;
        const pieces = Math.max(1, Math.ceil((4 * Math.max(Math.abs(dx), Math.abs(dy))) / cell));
        for (let k = 0; k <= pieces; ++k) put(ax + (k / pieces) * dx, ay + (k / pieces) * dy);
      }
      context.fillStyle = colour('box');
      context.strokeStyle = colour('focus');
      context.lineWidth = ratio * 0.6;
      for (const at of cells) {
        const column = (at % columns) - 1;
        const row = Math.floor(at / columns) - 1;
        const px = (x0 + column * cell - view.x) * scale + wide / 2;
        const py = high / 2 - (y0 + (row + 1) * cell - view.y) * scale;
        context.fillRect(px, py, cell * scale, cell * scale);
        if (cell * scale > 5) context.strokeRect(px, py, cell * scale, cell * scale);
      }
    }
    paint(context, plane, view, wide, high, ratio);
    canvas.setAttribute('aria-label', texts.boxesOf(plane.head.generation, Math.round(this.side)));
  }
}
