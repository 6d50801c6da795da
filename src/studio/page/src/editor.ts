// The editor: one view, three documents. What it says of a text is what `algae lsp` says of it.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, type Completion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import { Compartment, EditorState, StateEffect, StateField, type Range, type Text } from '@codemirror/state';
import { Decoration, drawSelection, EditorView, gutter, GutterMarker, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers, type DecorationSet } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { ask, askText, Latest, Refusal } from './ask';
import { engine } from './engine';
import type { Kind } from './state';
import { texts } from './texts';

interface Position {
  line: number;
  character: number;
}
interface Message {
  id?: number;
  method?: string;
  params?: { diagnostics: { range: { start: Position; end: Position }; message: string; data?: { suggestion: string } }[] };
  result?: unknown;
}

/** Asks the language server once: a document, and one request about it. */
async function askEditor(kind: Kind, text: string, method: string, place: Position | null, signal?: AbortSignal): Promise<Message[]> {
  if (kind === 'system' && !engine.isReady('editor')) return method === 'diagnostics' ? mistakeOf(text, signal) : [];
  const question: Record<string, unknown> = { question: 'editor', kind: kind === 'system' ? 'lsys' : kind === 'claim' ? 'claim' : answerKind(text), method, text };
  if (place) Object.assign(question, place);
  const answer = await ask(question, { part: 'about', ...(signal ? { signal } : {}) });
  const all = new TextDecoder().decode(answer.bytes);
  const messages: Message[] = [];
  // Lengths count bytes; the texts themselves hold no line that looks like a header.
  for (const part of all.split(/Content-Length: \d+\r\n\r\n/)) if (part) messages.push(JSON.parse(part) as Message);
  return messages;
}

/** Where the language server is not loaded: the first mistake of a system, as its reader says it. */
async function mistakeOf(text: string, signal?: AbortSignal): Promise<Message[]> {
  try {
    await askText({ question: 'describe', text }, { part: 'about', ...(signal ? { signal } : {}) });
    return [];
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    const line = Math.max((error.line ?? 1) - 1, 0);
    const range = { start: { line, character: 0 }, end: { line, character: Number.MAX_SAFE_INTEGER } };
    return [{ method: 'diagnostics', params: { diagnostics: [{ range, message: error.message }] } }];
  }
}

/** Answers of exercises are systems or claims. */
function answerKind(text: string): string {
  return /^\s*(let|show|claim|refute)\b/m.test(text) && !/^\s*axiom\b/m.test(text) ? 'claim' : 'lsys';
}

/** What lines of systems and claims begin with, from the tables of their readers (build.mjs). */
declare const algaeKeywords: string; // w1|w2|...
const keywords = new RegExp(`^(${algaeKeywords})\\b`);

const notation = StreamLanguage.define<{ start: boolean }>({
  startState: () => ({ start: true }),
  token(stream, at) {
    if (stream.sol()) at.start = true;
    if (stream.eatSpace()) return null;
    if (stream.match(/^#(?=\s|$).*/)) return 'comment';
    if (at.start && stream.match(keywords)) {
      const word = stream.current();
      at.start = false;
      if (/^(title|source|id|note|claim)$/.test(word)) {
        stream.skipToEnd();
        return 'string';
      }
      return 'keyword';
    }
    at.start = false;
    if (stream.match(/^(->|→|==>|:)/)) return 'operator';
    if (stream.match(/^[;{]/)) {
      at.start = true;
      return 'punctuation';
    }
    if (stream.match(/^(is|in|not|and|or|for all|exists|by)\b/)) return 'keyword';
    if (stream.match(/^\d+(\.\d+)?/)) return 'number';
    if (stream.match(/^[[\]]/)) return 'bracket';
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: '#' } },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: 'var(--quiet)', fontStyle: 'italic' },
  { tag: tags.keyword, color: 'var(--accent)', fontWeight: '600' },
  { tag: tags.string, color: 'var(--quiet)' },
  { tag: tags.operator, color: 'var(--focus)', fontWeight: '600' },
  { tag: tags.number, color: 'var(--open)' },
  { tag: tags.bracket, color: 'var(--focus)' },
]);

// Verdicts beside the lines of a claim.

class Verdict extends GutterMarker {
  constructor(readonly verdict: string) {
    super();
  }
  override eq(other: Verdict): boolean {
    return other.verdict === this.verdict;
  }
  override toDOM(): Node {
    const sign = document.createElement('span');
    sign.className = this.verdict === 'proved' ? 'good' : this.verdict === 'refuted' ? 'bad' : 'open';
    sign.textContent = this.verdict === 'proved' ? '✓' : this.verdict === 'refuted' ? '✗' : '?';
    sign.title = this.verdict;
    return sign;
  }
}
const setVerdicts = StateEffect.define<{ line: number; verdict: string }[]>();
const verdicts = StateField.define<Map<number, Verdict>>({
  create: () => new Map(),
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setVerdicts)) return new Map(effect.value.map((one) => [one.line, new Verdict(one.verdict)]));
    return transaction.docChanged ? new Map() : value;
  },
});
const verdictGutter = gutter({
  class: 'cm-verdicts',
  lineMarker: (view, line) => view.state.field(verdicts).get(view.state.doc.lineAt(line.from).number) ?? null,
  lineMarkerChange: (update) => update.startState.field(verdicts) !== update.state.field(verdicts),
});

// A line that the page points at: the rule of a letter.
const pointAt = StateEffect.define<number | null>();
const pointed = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    let found = value.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(pointAt)) {
        const marks: Range<Decoration>[] = [];
        if (effect.value !== null && effect.value <= transaction.state.doc.lines)
          marks.push(Decoration.line({ attributes: { style: 'background: var(--mark)' } }).range(transaction.state.doc.line(effect.value).from));
        found = Decoration.set(marks);
      }
    return found;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function offset(doc: Text, place: Position): number {
  const line = doc.line(Math.min(place.line + 1, doc.lines));
  return Math.min(line.from + place.character, line.to);
}

export class Editor {
  private made: EditorView | null = null;
  private kind: Kind = 'system';
  private readonly documents = new Map<Kind, EditorState>();
  private readonly latest = new Latest();
  private readonly label = new Compartment();

  constructor(
    private readonly parent: HTMLElement,
    private readonly changed: (kind: Kind, text: string) => void,
    private readonly found: (count: number, first: string) => void,
  ) {}

  /** Made when a document is shown first, as it takes longer to make than the rest of the page, which a first picture waits for. */
  get view(): EditorView {
    return (this.made ??= new EditorView({ parent: this.parent, state: this.fresh('', this.kind) }));
  }

  private fresh(text: string, kind: Kind): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        verdicts,
        verdictGutter,
        pointed,
        lintGutter(),
        history(),
        drawSelection(),
        bracketMatching(),
        closeBrackets(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        highlightSelectionMatches(),
        notation,
        syntaxHighlighting(colours),
        autocompletion({ override: [(context) => this.complete(context)] }),
        hoverTooltip((_view, at) => this.hover(at)),
        EditorView.lineWrapping,
        this.label.of(EditorView.contentAttributes.of({ 'aria-label': `${texts.documents[kind]}, ${texts.editor}` })),
        keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap]),
        EditorView.updateListener.of((update) => {
          if (!update.docChanged) return;
          this.changed(this.kind, update.state.doc.toString());
          void this.diagnose();
        }),
      ],
    });
  }

  /** Shows one of the documents, with this text. */
  show(kind: Kind, text: string): void {
    if (this.made) this.documents.set(this.kind, this.made.state);
    this.kind = kind;
    const before = this.documents.get(kind);
    const state = before && before.doc.toString() === text ? before : this.fresh(text, kind);
    if (this.made) this.made.setState(state);
    else this.made = new EditorView({ parent: this.parent, state });
    void this.diagnose();
  }

  holds(text: string): boolean {
    return this.made?.state.doc.toString() === text;
  }

  /** Replaces the text of the document that is shown; can be undone. */
  replace(text: string): void {
    const doc = this.view.state.doc;
    if (doc.toString() === text) return;
    this.view.dispatch({ changes: { from: 0, to: doc.length, insert: text } });
  }

  /** Replaces what a pattern finds, such as the value of a constant. */
  replaceMatch(pattern: RegExp, by: string): boolean {
    const text = this.view.state.doc.toString();
    const match = pattern.exec(text);
    if (!match) return false;
    const from = match.index + match[0].length - match[match.length - 1]!.length;
    this.view.dispatch({ changes: { from, to: match.index + match[0].length, insert: by } });
    return true;
  }

  judge(found: { line: number; verdict: string }[]): void {
    if (this.kind === 'claim') this.view.dispatch({ effects: setVerdicts.of(found) });
  }
  point(line: number | null): void {
    if (this.kind !== 'system' || (line === null && !this.made?.state.field(pointed).size)) return;
    this.view.dispatch({ effects: pointAt.of(line) });
  }
  focus(): void {
    this.view.focus();
  }

  private async diagnose(): Promise<void> {
    const { doc } = this.view.state;
    const text = doc.toString();
    const kind = this.kind;
    // The answer of an exercise may be a word or a language, which only the marking reads.
    if (kind === 'answer' && !/->|→|^\s*(axiom|let|show|claim)\b/m.test(text)) {
      this.latest.stop();
      this.view.dispatch(setDiagnostics(this.view.state, []));
      return this.found(0, '');
    }
    try {
      const messages = await this.latest.run((signal) => askEditor(kind, text, 'diagnostics', null, signal));
      if (!messages || kind !== this.kind || this.view.state.doc !== doc) return;
      const all: Diagnostic[] = [];
      for (const one of messages.find((message) => message.method)?.params?.diagnostics ?? []) {
        const from = offset(doc, one.range.start);
        const to = Math.max(from, offset(doc, one.range.end));
        const suggestion = one.data?.suggestion;
        all.push({
          from,
          to,
          severity: 'error',
          message: one.message,
          actions: suggestion ? [{ name: suggestion, apply: (view, start, end) => view.dispatch({ changes: { from: start, to: end, insert: suggestion } }) }] : [],
        });
      }
      this.view.dispatch(setDiagnostics(this.view.state, text.trim() ? all : []));
      this.found(text.trim() ? all.length : 0, all[0] ? texts.lineSaid(doc.lineAt(all[0].from).number, all[0].message) : '');
    } catch (error) {
      this.found(1, error instanceof Error ? error.message : String(error));
    }
  }

  private place(at: number): Position {
    const line = this.view.state.doc.lineAt(at);
    return { line: line.number - 1, character: at - line.from };
  }

  private async complete(context: CompletionContext): Promise<CompletionResult | null> {
    const word = context.matchBefore(/[\w-]*/);
    if (!word || (word.from === word.to && !context.explicit)) return null;
    const messages = await askEditor(this.kind, context.state.doc.toString(), 'completion', this.place(context.pos));
    const items = (messages.find((message) => message.id === 1)?.result ?? []) as { label: string; kind: number; detail?: string; documentation?: string | { value: string } }[];
    if (!Array.isArray(items) || items.length === 0) return null;
    const options: Completion[] = items.map((item) => {
      const info = typeof item.documentation === 'string' ? item.documentation : item.documentation?.value;
      return { label: item.label, type: item.kind === 14 ? 'keyword' : 'constant', ...(item.detail ? { detail: item.detail } : {}), ...(info ? { info } : {}) };
    });
    return { from: word.from, options, validFor: /^[\w-]*$/ };
  }

  private async hover(at: number): Promise<{ pos: number; create: () => { dom: HTMLElement } } | null> {
    const messages = await askEditor(this.kind, this.view.state.doc.toString(), 'hover', this.place(at));
    const said = messages.find((message) => message.id === 1)?.result as { contents: { value: string } } | null | undefined;
    if (!said) return null;
    return {
      pos: at,
      create: () => {
        const dom = document.createElement('div');
        dom.style.padding = '0.4em 0.7em';
        dom.style.whiteSpace = 'pre-wrap';
        dom.textContent = said.contents.value.replaceAll('**', '').replaceAll('`', '').trim();
        return { dom };
      },
    };
  }
}
