// Lessons: read, answer, be marked with the counterexample at once, hand the answer in. Exercises of somebody's own are a lesson without a text.

import { askJson, Refusal } from './ask';
import { download, el, speak } from './dom';
import { formula, withFormulas } from './growth';
import { change, state, type PackedExercise } from './state';
import { texts } from './texts';

interface Entry {
  lesson: number;
  title: string;
}
interface Exercise {
  exercise: string; // as people call it: 4.1, or the name of its file
  title: string;
  source?: string;
  task: string;
  ending: string; // of the name of a file with an answer
}
interface Lesson {
  title: string;
  text: string;
  exercises: Exercise[];
}
interface Mark {
  verdict: string;
  statements: { text: string; verdict: string; argument: string[]; hint?: string }[];
}

/** Emphasis, code, links and formulas within a line. */
function inline(text: string): Node {
  const all = document.createDocumentFragment();
  for (const part of text.split(/(`[^`]+`|\*\*[^*]+\*\*|\*[^*\s][^*]*\*|\[[^\]]+\]\([^)]+\)|\$[^$]+\$)/)) {
    if (!part) continue;
    if (part.startsWith('`')) all.append(el('code', {}, part.slice(1, -1)));
    else if (part.startsWith('**')) all.append(el('b', {}, part.slice(2, -2)));
    else if (part.startsWith('*') && part.length > 2) all.append(el('i', {}, part.slice(1, -1)));
    else if (part.startsWith('[')) all.append(part.replace(/\[([^\]]+)\].*/, '$1'));
    else if (part.startsWith('$')) all.append(formula(part.slice(1, -1)));
    else all.append(part);
  }
  return all;
}

/** The Markdown of lessons; `use` gets the text and the kind of a block that can be tried. */
export function markdown(text: string, use: (text: string, kind: 'system' | 'claim') => void): HTMLElement {
  const page = el('div', { class: 'lesson' });
  const lines = text.split('\n');
  for (let i = 0; i < lines.length; ) {
    const line = lines[i]!;
    if (line.startsWith('```')) {
      const kind = line.slice(3).split(' ')[0]!;
      const block: string[] = [];
      for (++i; i < lines.length && !lines[i]!.startsWith('```'); ++i) block.push(lines[i]!);
      ++i;
      const code = block.join('\n');
      page.append(el('pre', {}, code));
      if (kind === 'claim' || kind === 'lsys') page.append(el('button', { onclick: () => use(code + '\n', kind === 'claim' ? 'claim' : 'system') }, texts.tryIt));
    } else if (line.startsWith('$$')) {
      const block: string[] = [line.slice(2)];
      while (!block[block.length - 1]!.includes('$$') && ++i < lines.length) block.push(lines[i]!);
      ++i;
      page.append(formula(block.join('\n').replace('$$', ''), true));
    } else if (/^#+ /.test(line)) {
      page.append(el(line.startsWith('# ') ? 'h2' : 'h3', {}, inline(line.replace(/^#+ /, '')) as HTMLElement));
      ++i;
    } else if (/^(- |\d+\. )/.test(line)) {
      const list = el(line.startsWith('-') ? 'ul' : 'ol', {});
      while (i < lines.length && /^(- |\d+\. |\s+\S)/.test(lines[i]!)) {
        let item = lines[i]!.replace(/^(- |\d+\. )/, '');
        while (++i < lines.length && /^\s+\S/.test(lines[i]!)) item += ' ' + lines[i]!.trim();
        list.append(el('li', {}, inline(item) as HTMLElement));
      }
      page.append(list);
    } else if (line.trim() === '') {
      ++i;
    } else if (/^!\[/.test(line)) {
      page.append(el('p', { class: 'note' }, line.replace(/^!\[([^\]]*)\].*/, '$1')));
      ++i;
    } else {
      const block: string[] = [];
      while (i < lines.length && lines[i]!.trim() !== '' && !/^(```|#+ |- |\d+\. |\$\$)/.test(lines[i]!)) block.push(lines[i++]!);
      page.append(el('p', {}, inline(block.join(' ')) as HTMLElement));
    }
  }
  return page;
}

export class LessonsTab {
  readonly root = el('div', { class: 'panel whole', role: 'tabpanel', id: 'panel-lessons', 'aria-label': texts.tabs.lessons });
  private readonly chooser = el('select', { 'aria-label': texts.tabs.lessons });
  private readonly body = el('div', { class: 'panel', tabindex: '0' });
  private shown = '';
  private listed: Promise<Entry[]> | null = null;
  visible = false;

  constructor() {
    this.root.append(el('div', { class: 'bar' }, this.chooser, el('span', { class: 'note' }, texts.answerHere)), this.body);
    this.chooser.addEventListener('change', () => change({ lesson: Number(this.chooser.value) }));
  }

  async update(): Promise<void> {
    if (!this.visible) return;
    try {
      await this.list();
      const key = state.lesson > 0 ? String(state.lesson) : JSON.stringify(state.pack);
      if (this.shown === key) return;
      this.shown = key;
      const page = state.lesson > 0 ? await this.lesson(state.lesson) : await this.pack(state.pack);
      if (this.shown !== key) return;
      this.body.replaceChildren(page);
      this.body.scrollTop = 0;
    } catch (error) {
      this.shown = '';
      this.body.replaceChildren(el('p', { class: 'bad' }, error instanceof Error ? error.message : String(error)));
    }
  }

  /** The lessons, and the exercises of one's own where there are any. */
  private async list(): Promise<void> {
    this.listed ??= askJson<{ lessons: Entry[] }>({ question: 'lessons' }).then(({ lessons }) => lessons);
    let lessons: Entry[];
    try {
      lessons = await this.listed;
    } catch (error) {
      this.listed = null;
      throw error;
    }
    if (this.chooser.childElementCount !== lessons.length + (state.pack.length > 0 ? 1 : 0))
      this.chooser.replaceChildren(
        ...(state.pack.length > 0 ? [el('option', { value: 0 }, texts.ownExercises)] : []),
        ...lessons.map((one) => el('option', { value: one.lesson }, `${one.lesson}. ${one.title}`)),
      );
    this.chooser.value = String(state.lesson);
  }

  private async lesson(number: number): Promise<HTMLElement> {
    const lesson = await askJson<Lesson>({ question: 'lesson', lesson: number });
    const page = markdown(lesson.text, (text, kind) => change(kind === 'claim' ? { claim: text, tab: 'claims' } : { system: text, tab: 'figure', n: null }));
    lesson.exercises.forEach((exercise, i) => page.append(this.task(exercise, { lesson: number, exercise: i + 1 })));
    return page;
  }

  private async pack(pack: PackedExercise[]): Promise<HTMLElement> {
    const page = el('div', { class: 'lesson' }, el('h2', {}, texts.ownExercises));
    for (const { file, text } of pack) {
      const own = { exercise_text: text, file };
      try {
        page.append(this.task(await askJson<Exercise>({ question: 'exercise', ...own }), own));
      } catch (error) {
        if (!(error instanceof Refusal)) throw error;
        page.append(el('div', { class: 'task' }, el('h3', {}, file), el('p', { class: 'bad' }, error.line === null ? error.message : texts.lineSaid(error.line, error.message))));
      }
    }
    return page;
  }

  /** A task with its buttons; `which` says in a question which exercise it is. */
  private task(exercise: Exercise, which: Record<string, unknown>): HTMLElement {
    const verdict = el('div', { 'aria-live': 'polite' });
    const name = `${exercise.exercise}: ${exercise.title}`;
    return el(
      'div',
      { class: 'task' },
      el('h3', {}, `${texts.task} ${name}`),
      el('p', {}, withFormulas(exercise.task) as unknown as HTMLElement),
      exercise.source ? el('p', { class: 'note' }, exercise.source) : null,
      el('button', { class: 'main', onclick: () => void this.mark(which, verdict) }, texts.mark),
      ' ',
      el('button', { title: texts.handInHelp, onclick: () => this.handIn(exercise, verdict) }, texts.handIn),
      verdict,
    );
  }

  /** The answer as a file, for who marks those of a class with `algae mark`. */
  private handIn(exercise: Exercise, into: HTMLElement): void {
    if (!state.answer.trim()) return into.replaceChildren(el('p', { class: 'wait' }, texts.answerHere));
    const name = `${exercise.exercise}.${exercise.ending}`;
    download(state.answer, name, 'text/plain');
    into.append(el('p', { class: 'note' }, texts.handedIn(name)));
  }

  private async mark(which: Record<string, unknown>, into: HTMLElement): Promise<void> {
    into.replaceChildren(el('p', { class: 'wait' }, texts.working));
    try {
      const found = await askJson<Mark>({ question: 'mark', ...which, text: state.answer }, {}, [0, 1, 3]);
      const kind = found.verdict === 'right' ? 'good' : found.verdict === 'wrong' ? 'bad' : 'open';
      const page = el('div', {}, el('p', { class: kind }, el('b', {}, found.verdict === 'right' ? `✓ ${texts.right}` : found.verdict === 'wrong' ? `✗ ${texts.wrong}` : `? ${texts.undecided}`)));
      for (const one of found.statements) {
        const holds = one.verdict === 'proved';
        const fails = one.verdict === 'refuted';
        const said = el(
          'div',
          { class: `statement ${holds ? 'proved' : fails ? 'refuted' : 'unknown'}` },
          el('span', { class: `verdict ${holds ? 'good' : fails ? 'bad' : 'open'}` }, `${holds ? '✓' : fails ? '✗' : '?'} ${texts.verdicts[one.verdict] ?? one.verdict}`),
          ' ',
          el('code', {}, one.text),
        );
        if (!holds) {
          for (const sentence of one.argument) said.append(el('p', { class: 'note' }, sentence));
          if (one.hint) said.append(el('p', {}, el('b', {}, `${texts.hint}: `), one.hint));
        }
        page.append(said);
      }
      into.replaceChildren(page);
      speak(found.verdict);
    } catch (error) {
      into.replaceChildren(el('p', { class: 'bad' }, error instanceof Error ? error.message : String(error)));
    }
  }
}
