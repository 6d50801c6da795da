// Diagrams: dots, a line, axes with round numbers.

import { svg } from './dom';
import { texts } from './texts';

export interface PlotChoices {
  horizontal: string;
  vertical: string;
  dots: { x: number; y: number; said: string; used?: boolean }[];
  line?: [number, number][];
  logarithmic?: boolean; // the numbers are decimal logarithms: axes show powers of ten
  logarithmicX?: boolean;
  chosen?: (index: number) => void;
}

function ticks(low: number, high: number): number[] {
  const raw = (high - low) / 6 || 1;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= raw) ?? raw;
  const found: number[] = [];
  for (let at = Math.ceil(low / step) * step; at <= high + 1e-9 * step; at += step) found.push(Number(at.toPrecision(12)));
  return found;
}

/** Decimal logarithms of round numbers: powers of ten, and what lies between them where there are few. */
function logarithmicTicks(low: number, high: number): number[] {
  if (high - low > 3) {
    const step = Math.ceil((high - low) / 7);
    const found: number[] = [];
    for (let at = Math.ceil(low - 1e-9); at <= high + 1e-9; at += step) found.push(at);
    return found;
  }
  const found: number[] = [];
  const factors = high - low > 1.5 ? [1, 3] : [1, 2, 5];
  for (let power = Math.floor(low); power <= high; ++power)
    for (const factor of factors) {
      const at = power + Math.log10(factor);
      if (at >= low - 1e-9 && at <= high + 1e-9) found.push(at);
    }
  return found.length > 1 ? found : ticks(low, high);
}

const superscript = (value: number): string => String(value).replace('-', '⁻').replace(/\d/g, (digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]!);

function label(value: number, logarithmic: boolean): string {
  if (!logarithmic) return String(value);
  if (Math.abs(value) < 3.9) return String(Number((10 ** value).toPrecision(2)));
  const power = Math.floor(value + 1e-9);
  const factor = Number((10 ** (value - power)).toPrecision(2));
  return (factor === 1 ? '' : `${factor}·`) + `10${superscript(power)}`;
}

export function plot(choices: PlotChoices): SVGElement {
  const [wide, high] = [460, 330];
  const [left, right, top, bottom] = [66, 14, 14, 48];
  const all = [...choices.dots.map((dot): [number, number] => [dot.x, dot.y]), ...(choices.line ?? [])];
  const low = [Math.min(...all.map((one) => one[0])), Math.min(...all.map((one) => one[1]))] as [number, number];
  const top2 = [Math.max(...all.map((one) => one[0])), Math.max(...all.map((one) => one[1]))] as [number, number];
  if (top2[0] === low[0]) top2[0] += 1;
  if (top2[1] === low[1]) top2[1] += 1;
  const x = (value: number): number => left + ((value - low[0]) / (top2[0] - low[0])) * (wide - left - right - 10) + 5;
  const y = (value: number): number => high - bottom - ((value - low[1]) / (top2[1] - low[1])) * (high - top - bottom - 10) - 5;
  const picture = svg('svg', { class: 'plot', viewBox: `0 0 ${wide} ${high}`, width: wide, height: high, role: choices.chosen ? 'group' : 'img', 'aria-label': texts.against(choices.vertical, choices.horizontal) });
  for (const tick of (choices.logarithmicX ? logarithmicTicks : ticks)(low[0], top2[0]))
    picture.append(svg('line', { class: 'grid', x1: x(tick), x2: x(tick), y1: top, y2: high - bottom }), svg('text', { x: x(tick), y: high - bottom + 18, 'text-anchor': 'middle' }, label(tick, choices.logarithmicX ?? false)));
  for (const tick of (choices.logarithmic ? logarithmicTicks : ticks)(low[1], top2[1]))
    picture.append(svg('line', { class: 'grid', x1: left, x2: wide - right, y1: y(tick), y2: y(tick) }), svg('text', { x: left - 6, y: y(tick) + 4, 'text-anchor': 'end' }, label(tick, choices.logarithmic ?? false)));
  picture.append(
    svg('line', { class: 'axis', x1: left, x2: wide - right, y1: high - bottom, y2: high - bottom }),
    svg('line', { class: 'axis', x1: left, x2: left, y1: top, y2: high - bottom }),
    svg('text', { x: (left + wide - right) / 2, y: high - 10, 'text-anchor': 'middle' }, choices.horizontal),
    svg('text', { x: 16, y: (top + high - bottom) / 2, 'text-anchor': 'middle', transform: `rotate(-90 16 ${(top + high - bottom) / 2})` }, choices.vertical),
  );
  if (choices.line) picture.append(svg('polyline', { class: 'fit', points: choices.line.map((one) => `${x(one[0])},${y(one[1])}`).join(' ') }));
  const dots = choices.dots.map((dot, index) => {
    const circle = svg('circle', { class: dot.used ? 'dot used' : 'dot', cx: x(dot.x), cy: y(dot.y), r: 5 }, svg('title', {}, dot.said));
    if (choices.chosen) {
      circle.setAttribute('tabindex', '0');
      circle.setAttribute('role', 'button');
      circle.setAttribute('aria-label', dot.said);
      const choose = (): void => {
        for (const other of dots) other.classList.toggle('chosen', other === circle);
        choices.chosen!(index);
      };
      circle.addEventListener('pointerenter', choose);
      circle.addEventListener('focus', choose);
    }
    return circle;
  });
  picture.append(...dots);
  return picture;
}
