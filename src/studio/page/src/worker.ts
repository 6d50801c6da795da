// A Worker of the page of static files: it answers one question at a time.

import { load } from './load';
import { answerOf, type Make, type Said } from './program';

export type FromWorker = Said | { progress: string } | { module: WebAssembly.Module };
/** Without a module the Worker loads it, and says so before it answers; without a question that is all. */
export interface ToWorker {
  program: 'engine' | 'theory';
  module?: WebAssembly.Module;
  question: Record<string, unknown> | null;
  seconds: number;
}

/** What a Worker has, as far as it is used here. */
interface Place {
  importScripts(name: string): void;
  name: string;
  algaeEngine: Make;
  algaeTheory?: Make;
  postMessage(message: FromWorker, moved?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

const place = self as unknown as Place;
/** What emscripten writes beside the module; that of the engine stands behind this script (build.mjs). */
function makerOf(program: ToWorker['program']): Make {
  if (program === 'engine') return place.algaeEngine;
  if (!place.algaeTheory) place.importScripts('theory.js');
  return place.algaeTheory!;
}

/** The first Worker begins to load before it is asked. */
const early = place.name === 'first' ? load('engine.wasm') : null;

async function answer({ program, module, question, seconds }: ToWorker): Promise<void> {
  const found = module ?? (await (early ?? load(`${program}.wasm`)));
  if (!module) place.postMessage({ module: found });
  if (!question) return;
  const said = await answerOf(makerOf(program), found, question, seconds, (progress) => place.postMessage({ progress }));
  place.postMessage(said, [said.bytes.buffer as ArrayBuffer]);
}
// What is thrown out of a promise the page would not hear of.
place.onmessage = (event) =>
  void answer(event.data).catch((error: unknown) =>
    setTimeout(() => {
      throw error;
    }),
  );
