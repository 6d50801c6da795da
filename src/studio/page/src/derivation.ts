// The derivation: the words one under the other, or as a tree. A letter that is chosen shows its ancestors, and the rule that made it.

import { askJson, Latest } from './ask';
import { el, speak, svg } from './dom';
import type { Editor } from './editor';
import { state, withGeneration } from './state';
import { texts } from './texts';

interface Derivation {
  words: { symbols: string[]; parents: number[]; table?: string }[];
  asked: number;
  rounded: string | null; // why parameters are doubles
  full: boolean;
}

const mostSpans = 3000; // of one word
const mostLeaves = 160; // of a tree

export class DerivationTab {
  readonly root = el('div', { class: 'panel whole', role: 'tabpanel', id: 'panel-derivation', 'aria-label': texts.tabs.derivation });
  private readonly treeButton = el('button', { 'aria-pressed': 'false', onclick: () => this.toggle() }, texts.tree);
  private readonly said = el('span', { class: 'note', 'aria-live': 'polite' }, texts.clickLetter);
  private readonly body = el('div', { class: 'panel', tabindex: '0' });
  private readonly latest = new Latest();
  private found: Derivation | null = null;
  private letters: Map<string, Element> = new Map();
  private chosen: [number, number] | null = null;
  private asTree = false;
  private shownKey = '';
  visible = false;

  constructor(private readonly editor: Editor) {
    this.root.append(el('div', { class: 'bar' }, this.treeButton, this.said), this.body);
    this.body.addEventListener('keydown', (event) => this.key(event));
  }

  async update(): Promise<void> {
    if (!this.visible) return;
    const key = JSON.stringify([state.system, state.n, state.seed]);
    if (key === this.shownKey) return;
    try {
      const found = await this.latest.run((signal) => askJson<Derivation>(withGeneration('derivation'), { signal }));
      if (!found) return;
      this.shownKey = key;
      this.found = found;
      this.chosen = null;
      this.said.textContent = found.rounded ? `${texts.clickLetter} · ${texts.rounded(found.rounded)}` : texts.clickLetter;
      this.draw();
    } catch (error) {
      this.said.textContent = '';
      this.body.replaceChildren(el('p', { class: 'bad' }, error instanceof Error ? error.message : String(error)));
    }
  }

  private toggle(): void {
    this.asTree = !this.asTree;
    this.treeButton.setAttribute('aria-pressed', String(this.asTree));
    this.draw();
  }

  private draw(): void {
    const found = this.found;
    if (!found) return;
    this.letters = new Map();
    this.body.replaceChildren(this.asTree ? this.tree(found) : this.words(found));
    if (found.full) this.body.append(el('p', { class: 'wait' }, texts.wordsStop(found.words.length - 1)));
    if (this.chosen) this.choose(...this.chosen);
  }

  private words(found: Derivation): Node {
    const all = el('div', {});
    found.words.forEach((word, n) => {
      const symbols = el('div', { class: 'symbols' });
      word.symbols.slice(0, mostSpans).forEach((symbol, i) => {
        const span = el('span', { onclick: () => this.choose(n, i) }, symbol);
        this.letters.set(`${n} ${i}`, span);
        symbols.append(span);
      });
      if (word.symbols.length === 0) symbols.append('ε');
      if (word.symbols.length > mostSpans) symbols.append(el('i', { class: 'note' }, texts.more(word.symbols.length - mostSpans)));
      all.append(el('div', { class: 'generation' }, el('div', { class: 'number', title: word.table ? texts.table(word.table) : '' }, word.table ? `${n} ${word.table}` : String(n)), symbols));
    });
    return all;
  }

  private tree(found: Derivation): Node {
    // As many generations as stay readable.
    let last = 0;
    while (last + 1 < found.words.length && found.words[last + 1]!.symbols.length <= mostLeaves) ++last;
    const places: number[][] = [];
    const size = (symbol: string): number => Math.max(1.75, 0.72 * [...symbol].length + 0.8);
    let wide = 0;
    places[last] = found.words[last]!.symbols.map((symbol) => {
      wide += size(symbol);
      return wide - size(symbol) / 2;
    });
    for (let n = last - 1; n >= 0; --n) {
      const below = found.words[n + 1]!.parents;
      places[n] = found.words[n]!.symbols.map(() => NaN);
      const sums = found.words[n]!.symbols.map(() => [0, 0] as [number, number]);
      below.forEach((parent, i) => {
        const sum = sums[parent]!;
        sum[0] += places[n + 1]![i]!;
        ++sum[1];
      });
      let before = 0;
      sums.forEach((sum, i) => {
        // A letter without successors stands behind its neighbour.
        before = places[n]![i] = sum[1] > 0 ? sum[0] / sum[1] : before + 1.2;
      });
      wide = Math.max(wide, before + 1);
    }
    const unit = 17;
    const step = 62;
    const picture = svg('svg', { class: 'tree', width: wide * unit + 20, height: (last + 1) * step + 20, role: 'img', 'aria-label': texts.treeOf(last) });
    const x = (n: number, i: number): number => places[n]![i]! * unit + 10;
    const y = (n: number): number => n * step + 26;
    for (let n = 1; n <= last; ++n)
      found.words[n]!.parents.forEach((parent, i) => {
        const line = svg('line', { x1: x(n - 1, parent), y1: y(n - 1) + 12, x2: x(n, i), y2: y(n) - 13 });
        this.letters.set(`line ${n} ${i}`, line);
        picture.append(line);
      });
    for (let n = 0; n <= last; ++n)
      found.words[n]!.symbols.forEach((symbol, i) => {
        const letter = svg('g', { onclick: () => this.choose(n, i) }, [...symbol].length === 1 ? svg('circle', { cx: x(n, i), cy: y(n), r: 12 }) : null, svg('text', { x: x(n, i), y: y(n) + 5, 'font-size': 15 }, symbol));
        this.letters.set(`${n} ${i}`, letter);
        picture.append(letter);
      });
    const all = el('div', {}, picture as unknown as HTMLElement);
    if (last + 1 < found.words.length) all.append(el('p', { class: 'note' }, texts.treeStops(last, found.words.length - 1, mostLeaves)));
    return all;
  }

  /** Shows where a letter comes from. */
  private choose(n: number, i: number): void {
    const found = this.found!;
    for (const letter of this.letters.values()) letter.classList.remove('kin', 'chosen');
    this.chosen = [n, i];
    const chain: string[] = [];
    let place = i;
    for (let step = n; step >= 0; --step) {
      const symbol = found.words[step]!.symbols[place]!;
      chain.unshift(symbol);
      this.letters.get(`${step} ${place}`)?.classList.add('kin');
      this.letters.get(`line ${step} ${place}`)?.classList.add('kin');
      place = found.words[step]!.parents[place] ?? 0;
    }
    // What it becomes, as far as the words go.
    let kin = new Set([i]);
    for (let step = n + 1; step < found.words.length && kin.size > 0; ++step) {
      const next = new Set<number>();
      found.words[step]!.parents.forEach((parent, at) => {
        if (kin.has(parent)) {
          next.add(at);
          this.letters.get(`${step} ${at}`)?.classList.add('kin');
          this.letters.get(`line ${step} ${at}`)?.classList.add('kin');
        }
      });
      kin = next;
    }
    const letter = this.letters.get(`${n} ${i}`);
    letter?.classList.add('chosen');
    letter?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    let said = `${texts.ancestors}: ${chain.join(' → ')}`;
    if (n > 0) {
      const parent = found.words[n]!.parents[i]!;
      const made = found.words[n]!.symbols.filter((_, at) => found.words[n]!.parents[at] === parent).join('');
      const from = found.words[n - 1]!.symbols[parent]!;
      said += ` · ${texts.rule} ${from} → ${made}`;
      this.editor.point(ruleLine(state.system, from));
    } else {
      said += ` · ${texts.inAxiom}`;
      this.editor.point(ruleLine(state.system, null));
    }
    this.said.textContent = said;
    speak(said);
  }

  key(event: KeyboardEvent): boolean {
    if (!this.found) return false;
    const [n, i] = this.chosen ?? [0, 0];
    const length = (at: number): number => this.found!.words[at]?.symbols.length ?? 0;
    let next: [number, number] | null = null;
    if (event.key === 'ArrowRight') next = [n, Math.min(i + 1, length(n) - 1)];
    else if (event.key === 'ArrowLeft') next = [n, Math.max(i - 1, 0)];
    else if (event.key === 'ArrowUp' && n > 0) next = [n - 1, this.found.words[n]!.parents[i] ?? 0];
    else if (event.key === 'ArrowDown' && n + 1 < this.found.words.length) next = [n + 1, Math.max(0, this.found.words[n + 1]!.parents.indexOf(i))];
    if (!next || length(next[0]) === 0) return false;
    event.preventDefault();
    this.choose(...next);
    return true;
  }
}

/** The line of the first rule for a letter, or of the axiom; null where none is found. */
function ruleLine(text: string, symbol: string | null): number | null {
  const lines = text.split('\n');
  const letter = symbol?.replace(/\(.*$/s, '').replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const pattern = letter === undefined ? /(^|;)\s*axiom\b/ : new RegExp(`(^|[;{<])\\s*${letter}\\s*(\\([^)]*\\))?\\s*([>:].*)?(->|→|-\\S*->)`);
  const found = lines.findIndex((line) => pattern.test(line));
  return found < 0 ? null : found + 1;
}
