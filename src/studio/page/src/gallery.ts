// The gallery: every system that comes with algae, with a picture that is drawn when it comes into view.

import { askBytes, askFile, askJson } from './ask';
import { el } from './dom';
import { engine } from './engine';
import { fitted, paint, planeOf, type PlaneHead } from './figure';
import { texts } from './texts';

interface Entry {
  name: string;
  title?: string;
  source?: string;
  path: string;
  class: string;
}

export type Chosen = (from: 'gallery' | 'theory' | 'folder', name: string) => void;

export class Gallery {
  readonly dialog = el('dialog', { 'aria-label': texts.gallery });
  private readonly search = el('input', { type: 'search', placeholder: texts.search, 'aria-label': texts.search });
  private readonly cards = el('div', { class: 'cards', id: 'cards', tabindex: '0' });
  private readonly kinds = el('select', { 'aria-label': texts.kind }, el('option', { value: 'systems' }, texts.systems), el('option', { value: 'claims' }, texts.theory), el('option', { value: 'folder' }, texts.folder));
  private entries: Entry[] = [];
  private named: { files: string[]; claims: string[] } | null = null; // files of the folder, claims of the theory
  private readonly pictures = new Map<string, string>();
  private readonly queue: { name: string; into: HTMLElement }[] = [];
  private running = 0;
  private observer: IntersectionObserver | null = null;

  constructor(private readonly chosen: Chosen) {
    const { kinds } = this;
    kinds.addEventListener('change', () => void this.show(kinds.value));
    this.search.addEventListener('input', () => void this.show(kinds.value));
    this.dialog.append(el('div', { class: 'inside' }, el('div', { class: 'bar' }, this.search, kinds, el('button', { onclick: () => this.dialog.close() }, texts.close)), this.cards));
    this.dialog.addEventListener('close', () => (this.queue.length = 0));
  }

  async open(): Promise<void> {
    this.named = null; // the folder may have other files now
    this.dialog.showModal();
    this.search.focus();
    if (this.entries.length === 0) {
      this.cards.textContent = texts.working;
      try {
        this.entries = (await askJson<{ figures: Entry[] }>({ question: 'gallery' }, { part: 'cards' })).figures.filter((one) => one.path.endsWith('.lsys'));
      } catch (error) {
        this.cards.textContent = error instanceof Error ? error.message : String(error);
        return;
      }
    }
    void this.show(this.kinds.value);
  }

  private async show(kind: string): Promise<void> {
    this.observer?.disconnect();
    this.queue.length = 0;
    if (kind !== 'systems' && !this.named) {
      this.cards.textContent = texts.working;
      try {
        this.named = await askJson<{ files: string[]; claims: string[] }>({ question: 'start' }, { part: 'cards' });
      } catch (error) {
        this.cards.textContent = error instanceof Error ? error.message : String(error);
        return;
      }
      if (kind !== this.kinds.value) return; // another kind was chosen meanwhile
    }
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const has = (...texts_: (string | undefined)[]): boolean => words.every((word) => texts_.some((text) => text?.toLowerCase().includes(word)));
    if (kind !== 'systems') {
      const names = (kind === 'claims' ? this.named!.claims : this.named!.files).filter((name) => has(name.replaceAll('-', ' '), name));
      this.cards.replaceChildren(
        ...names.map((name) => {
          const short = name.split('/').pop()!;
          return el('button', { class: 'card', style: 'height: auto', onclick: () => this.choose(kind === 'claims' ? 'theory' : 'folder', name) }, el('b', {}, short.replace(/\.(claim|lsys)$/, '').replaceAll('-', ' ')), el('small', {}, name));
        }),
      );
      if (names.length === 0) this.cards.textContent = texts.nothing;
      return;
    }
    this.observer = new IntersectionObserver(
      (seen) => {
        for (const one of seen)
          if (one.isIntersecting) {
            this.observer!.unobserve(one.target);
            this.queue.push({ name: (one.target as HTMLElement).dataset['name']!, into: one.target as HTMLElement });
          }
        this.work();
      },
      { root: this.cards, rootMargin: '150px' },
    );
    const found = this.entries.filter((one) => has(one.name, one.title, one.source, one.class));
    this.cards.replaceChildren(
      ...found.map((one) => {
        const picture = el('div', { class: 'picture', 'data-name': one.name });
        const known = this.pictures.get(one.name);
        if (known) picture.append(el('img', { src: known, alt: '' }));
        else this.observer!.observe(picture);
        return el('button', { class: 'card', onclick: () => this.choose('gallery', one.name) }, picture, el('b', {}, one.title || one.name), el('small', {}, [one.name, one.class, one.source].filter(Boolean).join(' · ')));
      }),
    );
    if (found.length === 0) this.cards.textContent = texts.nothing;
  }

  private choose(from: 'gallery' | 'theory' | 'folder', name: string): void {
    this.dialog.close();
    this.chosen(from, name);
  }

  private work(): void {
    while (this.running < 3 && this.queue.length > 0) {
      const { name, into } = this.queue.shift()!;
      ++this.running;
      void this.picture(name)
        .then((address) => into.replaceChildren(el('img', { src: address, alt: '' })))
        .catch(() => into.replaceChildren(engine.lacks('picture') ? '' : texts.wordsOnly))
        .finally(() => {
          --this.running;
          this.work();
        });
    }
  }

  /** A picture that the page draws itself, where the engine makes no files of pictures. */
  private async painted(name: string): Promise<string> {
    const [width, height] = [240, 180];
    const { head, bytes } = await askBytes<PlaneHead>({ question: 'figure', name, pixels: width, most: 20_000, seconds: 4 }, { part: 'cards' });
    if (head.kind !== 'plane' || head.empty) throw new Error(texts.wordsOnly);
    const canvas = el('canvas', { width, height });
    paint(canvas.getContext('2d')!, planeOf({ head, bytes }), fitted(head.box, width, height), width, height, 1);
    const address = canvas.toDataURL();
    this.pictures.set(name, address);
    return address;
  }

  private async picture(name: string): Promise<string> {
    if (engine.lacks('picture')) return this.painted(name);
    const bytes = await askFile({ question: 'picture', name, format: 'png', width: 240, seconds: 4 }, { part: 'cards' });
    let text = '';
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    const address = `data:image/png;base64,${btoa(text)}`;
    this.pictures.set(name, address);
    return address;
  }
}
