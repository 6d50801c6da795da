// The language: is a word in it, and which words are.

import { askJson, Latest } from './ask';
import { el } from './dom';
import { change, described, state, systemQuestion } from './state';
import { texts } from './texts';

const longest = 16; // letters of a word that is listed

interface Member {
  member: boolean;
  step: number | null;
  derivation?: { word: string; table?: string; successors?: string[] }[];
  reason?: string;
}

export class LanguageTab {
  readonly root = el('div', { class: 'panel', role: 'tabpanel', id: 'panel-language', tabindex: '0', 'aria-label': texts.tabs.language });
  private readonly input = el('input', { type: 'text', size: 24, 'aria-label': texts.member, placeholder: 'abaab', spellcheck: 'false' });
  private readonly verdict = el('div', { 'aria-live': 'polite' });
  private readonly words = el('div', {});
  private readonly finite = el('p', {});
  private readonly decides = new Latest();
  private readonly lists = new Latest();
  private shownKey = '';
  visible = false;

  constructor() {
    const form = el('form', { class: 'columns', onsubmit: (event: Event) => event.preventDefault() }, el('label', {}, texts.member + ' ', this.input), el('span', { class: 'note' }, texts.empty));
    this.root.append(form, this.verdict, el('h2', {}, texts.finite), this.finite, el('h2', {}, texts.list), this.words);
    this.input.addEventListener('input', () => {
      change({ word: this.input.value.trim() });
      void this.decide();
    });
  }

  async update(): Promise<void> {
    if (!this.visible || !described() || this.shownKey === state.system) return;
    this.shownKey = state.system;
    if (this.input.value.trim() !== state.word) this.input.value = state.word;
    void this.decide();
    const fail = (error: unknown): HTMLElement => el('p', { class: 'wait' }, error instanceof Error ? error.message : String(error));
    await this.lists.run(async (signal) => {
      this.words.replaceChildren(el('p', { class: 'wait' }, texts.working));
      try {
        const { finite, count } = await askJson<{ finite: boolean; count: number | string | null }>(systemQuestion('finite'), { signal }, [0, 1]);
        this.finite.replaceChildren(finite ? texts.isFinite(String(count), Number(count)) : texts.isInfinite);
      } catch (error) {
        if (!signal.aborted) this.finite.replaceChildren(fail(error));
      }
      try {
        const { words } = await askJson<{ words: string[] }>(systemQuestion('list', { longest, seconds: 6 }), { signal }, [0, 1]);
        this.words.replaceChildren(el('p', { class: 'symbols' }, words.slice(0, 400).map((word) => word || 'ε').join('  ') + (words.length > 400 ? ' …' : '')), el('p', { class: 'note' }, texts.listed(longest)));
      } catch (error) {
        if (!signal.aborted) this.words.replaceChildren(fail(error));
      }
    });
  }

  private async decide(): Promise<void> {
    const word = this.input.value.trim();
    if (!word) {
      this.decides.stop();
      this.verdict.replaceChildren();
      return;
    }
    const wait = setTimeout(() => this.verdict.replaceChildren(el('p', { class: 'wait' }, texts.working)), 150);
    try {
      const found = await this.decides.run((signal) => askJson<Member>(systemQuestion('member', { word }), { signal }, [0, 1]));
      if (!found) return;
      const page = el('div', {}, el('p', { class: found.member ? 'good' : 'bad' }, el('b', {}, found.member ? texts.inLanguage(word) : texts.notInLanguage(word)), found.reason ? ` ${texts.reason}: ${found.reason}.` : ''));
      for (const [step, one] of (found.derivation ?? []).entries())
        page.append(el('div', { class: 'generation' }, el('div', { class: 'number' }, one.table ? `${step} ${one.table}` : String(step)), el('div', { class: 'symbols' }, one.word || 'ε')));
      this.verdict.replaceChildren(page);
    } catch (error) {
      this.verdict.replaceChildren(el('p', { class: 'wait' }, error instanceof Error ? error.message : String(error)));
    } finally {
      clearTimeout(wait);
    }
  }
}
