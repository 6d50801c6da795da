// Questions, and what becomes of their answers. The part of the page that waits for one is busy meanwhile.

import { busy } from './dom';
import { engine, type Answer } from './engine';
import { texts } from './texts';

/** What a person did wrong, or a bound that was reached; its message is meant for people. */
export class Refusal extends Error {
  constructor(
    message: string,
    readonly status: number,
    readonly line: number | null = null,
  ) {
    super(message);
  }
  get isBound(): boolean {
    return this.status === 3;
  }
}

export interface AskOptions {
  signal?: AbortSignal;
  progress?: (line: string) => void;
  part?: string; // of the page, which shows the answer: its id; the views, where nothing is said
}

const newline = 10;

/** Asks, and reads to the end. */
export async function ask(question: Record<string, unknown>, options: AskOptions = {}): Promise<Answer> {
  const done = busy(options.part ?? 'right');
  try {
    return await engine.answer(
      question,
      options.signal ?? null,
      (line) => options.progress?.(line),
      (message) => new Refusal(message, 2),
    );
  } finally {
    done();
  }
}

function explain(answer: Answer): string {
  if (answer.end === 'time') return texts.tookLonger(answer.seconds);
  if (answer.end === 'size') return texts.tooLarge;
  if (answer.end === 'broken') return texts.broken;
  return answer.said.replace(/^algae: /gm, '').trim() || texts.noAnswer;
}

/** The text of an answer; throws a Refusal where there is none. `fine` are the exit statuses that come with an answer. */
export async function askText(question: Record<string, unknown>, options: AskOptions = {}, fine = [0]): Promise<string> {
  const answer = await ask(question, options);
  const text = new TextDecoder().decode(answer.bytes);
  if (answer.end === 'answered' && fine.includes(answer.status)) return text;
  throw refusalOf(answer, text);
}

function refusalOf(answer: Answer, text: string): Refusal {
  if (answer.end === 'answered')
    try {
      const said = JSON.parse(text) as { error?: { message: string; line?: number | null } };
      if (said.error) return new Refusal(said.error.message, answer.status, said.error.line ?? null);
    } catch {
      // the verb wrote no JSON: its words are in `said`
    }
  return new Refusal(explain(answer), answer.end === 'answered' ? answer.status : 3);
}

export async function askJson<T>(question: Record<string, unknown>, options: AskOptions = {}, fine = [0]): Promise<T> {
  const answer = await ask(question, options);
  const text = new TextDecoder().decode(answer.bytes);
  if (answer.end !== 'answered' || !fine.includes(answer.status)) throw refusalOf(answer, text);
  const found = JSON.parse(text) as T;
  // A status that may come with an answer, such as that of a bound that was reached, may come without one too.
  if (answer.status !== 0 && typeof found === 'object' && found !== null && 'error' in found) throw refusalOf(answer, text);
  return found;
}

/** An answer that is a line of JSON and then numbers, or a file. */
export async function askBytes<T>(question: Record<string, unknown>, options: AskOptions = {}): Promise<{ head: T; bytes: Uint8Array }> {
  const answer = await ask(question, options);
  if (answer.end !== 'answered' || answer.status !== 0)
    throw refusalOf(answer, new TextDecoder().decode(answer.bytes.subarray(0, 100_000)));
  const end = answer.bytes.indexOf(newline);
  return {
    head: JSON.parse(new TextDecoder().decode(answer.bytes.subarray(0, end))) as T,
    bytes: answer.bytes.slice(end + 1),
  };
}

export async function askFile(question: Record<string, unknown>, options: AskOptions = {}): Promise<Uint8Array> {
  const answer = await ask(question, options);
  if (answer.end !== 'answered' || answer.status !== 0 || answer.bytes.length === 0)
    throw refusalOf(answer, new TextDecoder().decode(answer.bytes.subarray(0, 100_000)));
  return answer.bytes;
}

/** Work of which only the newest matters: to begin one ends the one before, on the server too. */
export class Latest {
  private controller: AbortController | null = null;

  async run<T>(work: (signal: AbortSignal) => Promise<T>): Promise<T | undefined> {
    this.stop();
    const controller = new AbortController();
    this.controller = controller;
    try {
      const result = await work(controller.signal);
      return controller.signal.aborted ? undefined : result;
    } catch (error) {
      if (controller.signal.aborted) return undefined;
      throw error;
    } finally {
      if (this.controller === controller) this.controller = null;
    }
  }
  stop(): void {
    this.controller?.abort();
    this.controller = null;
  }
  get isRunning(): boolean {
    return this.controller !== null;
  }
}
