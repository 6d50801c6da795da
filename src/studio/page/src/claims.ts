// Claims: each statement with its verdict, the argument folded under it; a search says how far it is and can be stopped.

import { askFile, askJson, Latest, Refusal } from './ask';
import { busy, download, el, speak } from './dom';
import type { Editor } from './editor';
import { state } from './state';
import { texts } from './texts';

interface Claim {
  claim: string;
  verdict: string;
  theorem?: { text: string; verdict: string; method?: string; searched?: Record<string, number> } & Record<string, unknown>;
  statements: { text: string; verdict: string; holds?: boolean; argument: string[]; citation?: string }[];
}

const quickSeconds = 4;

/** The lines that say statements, in order, counted from 1. */
function statementLines(text: string): number[] {
  const found: number[] = [];
  text.split('\n').forEach((line, at) => {
    for (const part of line.split(';')) if (/^\s*(show|lemma|refute|closed|not closed)\b/.test(part)) found.push(at + 1);
  });
  return found;
}

function kindOf(verdict: string): string {
  if (/^proved|^examples|^holds/.test(verdict)) return 'proved';
  if (/^refuted|^wrong/.test(verdict)) return 'refuted';
  return 'unknown';
}

export class ClaimsTab {
  readonly root = el('div', { class: 'panel whole', role: 'tabpanel', id: 'panel-claims', 'aria-label': texts.tabs.claims });
  private readonly checkButton = el('button', { class: 'main', onclick: () => void this.check(null) }, texts.check);
  private readonly stopButton = el('button', { disabled: true, onclick: () => this.stop() }, texts.stop);
  private readonly instances = el('input', { type: 'number', class: 'long', min: 1, step: 1, value: 100000, 'aria-label': texts.instances });
  private readonly progress = el('span', { class: 'wait', role: 'status' });
  private readonly body = el('div', { class: 'panel', tabindex: '0' });
  private readonly latest = new Latest();
  private shownKey = '';
  private timer = 0;
  private waits: (() => void) | null = null;
  visible = false;

  constructor(private readonly editor: Editor) {
    this.root.append(
      el(
        'div',
        { class: 'bar' },
        this.checkButton,
        this.stopButton,
        el('label', {}, texts.instances, this.instances),
        el('button', { onclick: () => void this.certificate() }, texts.certificate),
        this.progress,
      ),
      this.body,
    );
    this.body.append(el('p', { class: 'note' }, texts.checkAgain));
  }

  update(): void {
    if (!this.visible || this.shownKey === state.claim) return;
    this.shownKey = state.claim;
    clearTimeout(this.timer);
    this.waits?.();
    this.waits = busy('right');
    this.timer = window.setTimeout(() => {
      void this.check(quickSeconds);
      this.waits?.();
    }, 60);
  }

  private stop(): void {
    this.latest.stop();
    this.progress.textContent = texts.stopped;
    this.stopButton.disabled = true;
  }

  private async check(seconds: number | null): Promise<void> {
    const text = state.claim;
    if (!text.trim()) {
      this.body.replaceChildren(el('p', { class: 'note' }, texts.checkAgain));
      return;
    }
    this.stopButton.disabled = false;
    const wait = setTimeout(() => (this.progress.textContent = texts.working), 120);
    try {
      const question: Record<string, unknown> = { question: 'check', text };
      if (seconds !== null) {
        question['seconds'] = seconds;
      } else {
        question['instances'] = Math.max(1, Math.floor(Number(this.instances.value)) || 1);
      }
      const begun = performance.now();
      const found = await this.latest.run((signal) =>
        askJson<{ claims: Claim[] }>(question, { signal, progress: (line) => (this.progress.textContent = line.replace(/^algae: /, '')) }, [0, 1, 3]),
      );
      if (!found) return;
      this.progress.textContent = `${((performance.now() - begun) / 1000).toFixed(1)} s`;
      this.stopButton.disabled = true;
      this.show(found.claims[0]!, text);
    } catch (error) {
      this.stopButton.disabled = true;
      this.progress.textContent = '';
      const bound = error instanceof Refusal && error.isBound;
      this.body.replaceChildren(el('p', { class: bound ? 'wait' : 'bad' }, error instanceof Error ? error.message : String(error)));
      if (bound && seconds !== null) this.body.append(el('p', { class: 'note' }, texts.lookedAt(seconds)));
      this.editor.judge([]);
    } finally {
      clearTimeout(wait);
    }
  }

  private show(claim: Claim, text: string): void {
    const lines = statementLines(text);
    const page = el('div', {}, el('h2', {}, claim.claim));
    const marks: { line: number; verdict: string }[] = [];
    claim.statements.forEach((statement, i) => {
      const kind = kindOf(statement.verdict);
      const line = lines[i];
      if (line !== undefined && lines.length === claim.statements.length) marks.push({ line, verdict: kind });
      const argument = el('details', {}, el('summary', {}, texts.argument));
      for (const sentence of statement.argument) argument.append(el('p', {}, sentence));
      page.append(
        el(
          'div',
          { class: `statement ${kind}` },
          el('span', { class: `verdict ${kind === 'proved' ? 'good' : kind === 'refuted' ? 'bad' : 'open'}` }, `${kind === 'proved' ? '✓' : kind === 'refuted' ? '✗' : '?'} ${texts.verdicts[statement.verdict] ?? statement.verdict}`),
          ' ',
          el('code', {}, statement.text),
          statement.holds === false ? el('b', { class: 'bad' }, ` — ${texts.otherwise}`) : null,
          statement.citation ? el('div', { class: 'note' }, statement.citation) : null,
          statement.argument.length > 0 ? argument : null,
        ),
      );
    });
    const theorem = claim.theorem;
    if (theorem) {
      const witness = (theorem['counterexample'] ?? theorem['example']) as Record<string, string> | undefined;
      page.append(el('h3', {}, texts.asTheorem), el('p', {}, el('b', {}, theorem.verdict), ': ', el('code', {}, theorem.text)));
      if (witness) {
        page.append(el('p', {}, theorem['counterexample'] ? texts.counterexample : texts.example, ': ', Object.entries(witness).map(([name, value]) => `${name} = ${value}`).join(', ')));
      }
      if (theorem.searched)
        page.append(el('p', { class: 'note' }, texts.searched(Object.entries(theorem.searched).map(([name, value]) => `${name} ${value}`).join(', '))));
    }
    this.body.replaceChildren(page);
    this.editor.judge(marks);
    speak(`${claim.claim}: ${claim.verdict}`);
  }

  /** Opens the argument of the next statement, or closes all: for presentations. */
  key(event: KeyboardEvent): boolean {
    if (event.key !== 'ArrowRight' && event.key !== 'ArrowLeft' && event.key !== 'PageDown' && event.key !== 'PageUp') return false;
    const all = [...this.body.querySelectorAll('details')];
    if (all.length === 0) return false;
    const open = all.findLastIndex((one) => one.open);
    const forward = event.key === 'ArrowRight' || event.key === 'PageDown';
    const next = Math.max(-1, Math.min(all.length - 1, open + (forward ? 1 : -1)));
    all.forEach((one, i) => (one.open = i === next));
    all[next]?.scrollIntoView({ block: 'nearest' });
    event.preventDefault();
    return true;
  }

  private async certificate(): Promise<void> {
    this.progress.textContent = texts.working;
    try {
      download(await askFile({ question: 'certificate', text: state.claim }), 'certificate.json', 'application/json');
      this.progress.textContent = '';
    } catch (error) {
      this.progress.textContent = error instanceof Error ? error.message : String(error);
    }
  }
}
