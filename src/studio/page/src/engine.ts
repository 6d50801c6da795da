// Who answers the page's questions: the server that it came from, or, where the page is a folder of static files, the engine as
// WebAssembly in Workers. Both take the same questions and give the same answers; the page only knows this face.

import type { Early } from './early';
import { load } from './load';
import type { Said } from './program';
import { texts } from './texts';
import type { FromWorker, ToWorker } from './worker';

export interface Head {
  status: number;
  end: 'answered' | 'gone' | 'time' | 'size' | 'broken';
  said: string;
  seconds: number;
}
export interface Answer extends Head {
  bytes: Uint8Array;
}
export type Question = Record<string, unknown>;

export interface Engine {
  /** Answers to the end; an aborted question ends at once with an AbortError. `refuse` makes the error of a question that is not taken. */
  answer(question: Question, signal: AbortSignal | null, progress: (line: string) => void, refuse: (message: string) => Error): Promise<Answer>;
  /** Why a question is not answered here; null where it is. */
  lacks(question: string): string | null;
  /** Whether a question is answered without anything that has to be loaded first. */
  isReady(question: string): boolean;
}

const newline = 10;
const tilde = 126;

/** An answer of the server is a stream: lines that begin with ~ say how far the work is, then one line of JSON says how it ended, and the
 * bytes behind it are the answer itself. */
const server: Engine = {
  lacks: () => null,
  isReady: () => true,
  async answer(question, signal, progress, refuse) {
    const response = await fetch('ask', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(question), signal });
    if (!response.ok) throw refuse((await response.text()).trim());
    const reader = response.body!.getReader();
    const pieces: Uint8Array[] = [];
    let rest = new Uint8Array(0);
    let head: Head | null = null;
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      if (head) {
        pieces.push(value);
        continue;
      }
      const joined = new Uint8Array(rest.length + value.length);
      joined.set(rest);
      joined.set(value, rest.length);
      let from = 0;
      for (let end = joined.indexOf(newline); end >= 0 && !head; end = joined.indexOf(newline, from)) {
        const line = new TextDecoder().decode(joined.subarray(from, end));
        if (joined[from] === tilde) progress(line.slice(1));
        else if (line) head = JSON.parse(line) as Head;
        from = end + 1;
      }
      rest = joined.slice(from);
    }
    if (!head) throw refuse(texts.ended);
    const bytes = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, rest.length));
    bytes.set(rest);
    let at = rest.length;
    for (const piece of pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    return { ...head, bytes };
  },
};

/** What the engines of static files are built without (tools/engine says which rooms they have): pictures as files, and the graph of letters,
 * which needs Graphviz, half of the page's bytes. */
export const leftOut = ['picture', 'letters'];
/** What the engine of figures answers, which is loaded first. The engine of the theory answers the rest, and is loaded when it is asked. */
const quick = ['describe', 'show', 'figure', 'derivation', 'walk', 'growth', 'factors', 'growth-latex', 'gallery'];

type Program = 'engine' | 'theory';
function programOf(question: Question): Program {
  const name = String(question['question']);
  return quick.includes(name) || (name === 'open' && question['from'] === 'gallery') ? 'engine' : 'theory';
}

const usualSeconds = 30;

/** A question that waits for a Worker or is with one. */
interface Task {
  program: Program;
  question: Question;
  seconds: number;
  progress: (line: string) => void;
  done: (answer: Answer) => void;
  fail: (error: unknown) => void;
}

/** What a page of static files begins before its script is read. */
declare const algaeEarly: Early | undefined;

function noAnswer(end: Head['end'], { seconds }: Task): Answer {
  return { status: 3, end, said: '', seconds, bytes: new Uint8Array(0) };
}
function answerFrom({ status, said, broken, bytes }: Said, task: Task): Answer {
  return broken ? noAnswer('broken', task) : { status, end: 'answered', said, seconds: task.seconds, bytes };
}

/** The engines in Workers. A Worker has one question at a time; to end the question is to end the Worker, and the next one gets the compiled
 * module, which is what takes long to make. */
class Workers implements Engine {
  private readonly coming = new Map<Program, Promise<WebAssembly.Module>>();
  private readonly modules = new Map<Program, WebAssembly.Module>();
  private readonly idle: Worker[] = [];
  private readonly waiting: Task[] = [];
  private readonly stops = new Map<Task, () => void>();
  private running = 0;
  private early: Early | null = null;

  constructor(private readonly most: number) {
    if (typeof algaeEarly === 'undefined') return;
    const { worker, module, isFree } = (this.early = algaeEarly);
    this.coming.set('engine', module);
    ++this.running;
    void isFree.then((free) => {
      if (free) this.idle.push(worker);
      else worker.terminate();
      --this.running;
      this.work();
    });
  }

  /** The answer that the page asked for before its script was there, if this is its question. */
  private asked(question: Question): Promise<Said> | null {
    const first = this.early?.question;
    if (!first) return null;
    const { question: name, text, pixels, ...more } = question;
    if (name !== first.question || text !== first.text || Number(pixels) > first.pixels || Object.keys(more).length > 0) return null;
    const { said } = this.early!;
    this.early = null;
    return said;
  }

  lacks(question: string): string | null {
    return leftOut.includes(question) ? texts.needsCommand : null;
  }

  isReady(question: string): boolean {
    return this.modules.has(programOf({ question }));
  }

  answer(question: Question, signal: AbortSignal | null, progress: (line: string) => void, refuse: (message: string) => Error): Promise<Answer> {
    const reason = this.lacks(String(question['question']));
    if (reason) return Promise.reject(refuse(reason));
    return new Promise((done, fail) => {
      const seconds = Number(question['seconds']);
      const task: Task = { program: programOf(question), question, seconds: seconds > 0 && seconds < usualSeconds ? seconds : usualSeconds, progress, done, fail };
      if (signal?.aborted) return fail(signal.reason);
      const early = this.asked(question);
      if (early) {
        signal?.addEventListener('abort', () => fail(signal.reason));
        early.then(
          (found) => done(answerFrom(found, task)),
          () => void this.wait(task),
        );
        return;
      }
      signal?.addEventListener('abort', () => {
        const at = this.waiting.indexOf(task);
        if (at >= 0) this.waiting.splice(at, 1);
        fail(signal.reason);
        this.stops.get(task)?.();
      });
      void this.wait(task);
    });
  }

  private wait(task: Task): Promise<void> {
    this.waiting.push(task);
    return this.prepare(task.program);
  }

  /** Loads a program if it is not there, and goes on with what waits for it; if it cannot be loaded it is tried again with the next question. */
  private async prepare(program: Program): Promise<void> {
    try {
      if (!this.modules.has(program)) {
        if (!this.coming.has(program)) this.coming.set(program, load(`${program}.wasm`));
        this.modules.set(program, await this.coming.get(program)!);
      }
    } catch {
      this.coming.delete(program);
      for (const task of this.waiting.filter((one) => one.program === program)) {
        this.waiting.splice(this.waiting.indexOf(task), 1);
        task.fail(new Error(texts.noEngine(`${program}.wasm`)));
      }
    }
    this.work();
  }

  private work(): void {
    while (this.running < this.most) {
      const at = this.waiting.findIndex((task) => this.modules.has(task.program));
      if (at < 0) return;
      this.begin(this.waiting.splice(at, 1)[0]!);
    }
  }

  private begin(task: Task): void {
    ++this.running;
    const worker = this.idle.pop() ?? new Worker('worker.js');
    const end = (keep: boolean): void => {
      clearTimeout(clock);
      this.stops.delete(task);
      worker.onmessage = worker.onerror = null;
      if (keep) this.idle.push(worker);
      else worker.terminate();
      --this.running;
      this.work();
    };
    const broken = (why: Head['end']): void => {
      end(false);
      task.done(noAnswer(why, task));
    };
    // The engine says itself when its time is over; this is for work that does not look.
    const clock = setTimeout(() => broken('time'), (task.seconds + 2) * 1000);
    this.stops.set(task, () => end(false));
    worker.onerror = () => broken('broken');
    worker.onmessage = (event: MessageEvent<FromWorker>) => {
      const found = event.data;
      if ('progress' in found) return task.progress(found.progress);
      if ('module' in found) return;
      end(!found.broken);
      task.done(answerFrom(found, task));
    };
    worker.postMessage({ program: task.program, module: this.modules.get(task.program)!, question: task.question, seconds: task.seconds } satisfies ToWorker);
  }
}

/** A page of static files says so in its first element. */
export const isStatic = document.documentElement.dataset['engine'] === 'static';
export const engine: Engine = isStatic ? new Workers(Math.max(1, Math.min(3, (navigator.hardwareConcurrency || 2) - 1))) : server;
