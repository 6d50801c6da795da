// Growth: formulas, the plot of lengths, the matrix, the graph of letters; and the factors of the words.

import type katex from 'katex';
import { askJson, askText, Latest, Refusal } from './ask';
import { busy, el } from './dom';
import { plot } from './plot';
import { described, state, systemQuestion } from './state';
import { engine } from './engine';
import { texts } from './texts';

interface Growth {
  lengths: (number | string)[];
  class: string;
  degree: number;
  rate: { exact: string | null; decimal: string } | null;
  letters: unknown;
}

let typesetter: Promise<typeof katex> | null = null;

/** A formula as MathML, which the browser sets with its own letters. */
export function formula(latex: string, display = false): HTMLElement {
  const element = el('span', display ? { class: 'formula' } : {}, latex);
  const done = busy('right');
  typesetter ??= import('katex').then((library) => library.default);
  void typesetter
    .then((found) => {
      found.render(latex, element, { output: 'mathml', displayMode: display, throwOnError: false, strict: false });
      // A bracket that is a letter is as high as one.
      for (const bracket of element.querySelectorAll('mtd mo:only-child')) bracket.setAttribute('stretchy', 'false');
    })
    .finally(done);
  return element;
}

/** Text with formulas between dollar signs. */
export function withFormulas(text: string): Node {
  const all = document.createDocumentFragment();
  text.split(/(\$[^$]+\$)/).forEach((part) => {
    if (part.startsWith('$') && part.length > 2) all.append(formula(part.slice(1, -1)));
    else all.append(part);
  });
  return all;
}

/** What a verb prints as LaTeX: displays, aligned lines, and sentences with formulas. */
export function latexPage(latex: string): HTMLElement {
  const page = el('div', {});
  for (const part of latex.split(/(\\\[[\s\S]*?\\\]|\\begin\{align\*\}[\s\S]*?\\end\{align\*\})/)) {
    const text = part.trim();
    if (!text) continue;
    if (text.startsWith('\\[')) page.append(formula(text.slice(2, -2), true));
    else if (text.startsWith('\\begin{align*}')) page.append(formula(text.replaceAll('align*', 'aligned'), true));
    else for (const line of text.split(/\n\s*\n/)) page.append(el('p', {}, withFormulas(line.replace(/\\\\\s*$/gm, '')) as unknown as HTMLElement));
  }
  return page;
}

/** The decimal logarithm of a whole number of any size. */
export function logarithm(value: number | string): number {
  const digits = String(value);
  return Math.log10(Number(`0.${digits.slice(0, 17)}`)) + digits.length;
}

let graphviz: Promise<{ renderSVGElement(text: string): SVGSVGElement }> | null = null;

export async function graphOf(dot: string): Promise<SVGSVGElement> {
  const done = busy('right');
  try {
    graphviz ??= import('@viz-js/viz').then((library) => library.instance());
    const picture = (await graphviz).renderSVGElement(dot);
    // What is said of it instead: letters, and where arrows lead. The titles are names inside of Graphviz.
    const named = (group: Element): string => group.querySelector('title')?.textContent ?? '';
    const letters = new Map([...picture.querySelectorAll('g.node')].map((node) => [named(node), node.querySelector('text')?.textContent ?? '']));
    const arrows = [...picture.querySelectorAll('g.edge')].map((edge) => named(edge).split('->').map((end) => letters.get(end) ?? '').join(' → '));
    for (const title of picture.querySelectorAll('title')) title.remove();
    for (const link of picture.querySelectorAll('a')) link.removeAttribute('title');
    picture.setAttribute('role', 'img');
    picture.setAttribute('aria-label', `${texts.letters}: ${[...letters.values()].join(', ')}. ${texts.arrows}: ${arrows.join(', ')}`);
    return picture;
  } finally {
    done();
  }
}

export class GrowthTab {
  readonly root = el('div', { class: 'panel', role: 'tabpanel', id: 'panel-growth', tabindex: '0', 'aria-label': texts.tabs.growth });
  private readonly latest = new Latest();
  private shownKey = '';
  visible = false;

  /** Counting factors takes long: it ends when its system is no longer there. */
  forget(): void {
    this.latest.stop();
  }

  async update(): Promise<void> {
    const about = described();
    if (!this.visible || !about || this.shownKey === state.system) return;
    if (!about.d0l) {
      this.shownKey = state.system;
      this.root.replaceChildren(el('p', { class: 'note' }, texts.onlyD0L), el('p', {}, texts.classOfSystem(about.class)));
      return;
    }
    const key = state.system;
    try {
      await this.latest.run(async (signal) => {
        const growth = await askJson<Growth>(systemQuestion('growth'), { signal });
        const noGraph = engine.lacks('letters');
        const [latex, dot] = await Promise.all([askText(systemQuestion('growth-latex'), { signal }), noGraph ? '' : askText(systemQuestion('letters'), { signal })]);
        if (signal.aborted) return;
        this.shownKey = key;
        const numbers = growth.lengths.map((length, n) => ({ n, length }));
        const exponential = growth.class === 'exponential';
        const shown = numbers.filter(({ length }) => !exponential || (length !== 0 && length !== '0'));
        const picture = plot({
          horizontal: texts.generation,
          vertical: texts.length,
          logarithmic: exponential,
          dots: shown.map(({ n, length }) => ({ x: n, y: exponential ? logarithm(length) : Number(length), said: `n = ${n}: ${length}` })),
        });
        const graph = el('div', { class: 'graph' }, texts.working);
        const factors = el('div', {}, el('p', { class: 'note' }, texts.working));
        this.root.replaceChildren(
          el('div', { class: 'columns' }, el('div', {}, el('h2', {}, texts.growthClass), latexPage(latex)), el('div', {}, el('h2', {}, texts.lengths), picture as unknown as HTMLElement)),
          el('h2', {}, texts.letters),
          el('p', { class: 'note' }, texts.lettersHelp),
          graph,
          el('h2', {}, texts.factors),
          factors,
        );
        if (noGraph) graph.replaceChildren(el('p', { class: 'note' }, noGraph));
        else try {
          // Colours of the graph are the system's own; what lies behind is the page's.
          graph.replaceChildren(await graphOf(dot.replace(/fillcolor="#(\w+)"/g, (_, hex: string) => `fillcolor="#${hex}"`)));
        } catch (error) {
          graph.textContent = String(error);
        }
        await this.factors(factors, signal);
      });
    } catch (error) {
      this.root.replaceChildren(el('p', { class: error instanceof Refusal && error.isBound ? 'wait' : 'bad' }, error instanceof Error ? error.message : String(error)));
    }
  }

  private async factors(into: HTMLElement, signal: AbortSignal): Promise<void> {
    try {
      const found = await askJson<Record<string, unknown>>(systemQuestion('factors', { seconds: 8 }), { signal });
      if (signal.aborted) return;
      into.replaceChildren(table(found));
    } catch (error) {
      if (!signal.aborted) into.replaceChildren(el('p', { class: 'wait' }, error instanceof Error ? error.message : String(error)));
    }
  }
}

/** Any report as a table of its keys. */
export function table(report: Record<string, unknown>): HTMLElement {
  const rows = el('tbody', {});
  const say = (value: unknown): string => {
    if (value === null) return '—';
    if (typeof value === 'boolean') return value ? texts.yes : texts.no;
    if (Array.isArray(value)) return value.length === 0 ? '—' : value.map(say).join(typeof value[0] === 'object' ? '; ' : ', ');
    if (typeof value === 'object') return Object.entries(value as Record<string, unknown>).map(([key, one]) => `${key.replaceAll('_', ' ')}: ${say(one)}`).join(', ');
    return String(value);
  };
  for (const [key, value] of Object.entries(report)) rows.append(el('tr', {}, el('th', { scope: 'row' }, key.replaceAll('_', ' ')), el('td', {}, say(value))));
  return el('table', {}, rows);
}
