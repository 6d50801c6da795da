// A Worker of the page of static files: it answers one question at a time.

import { answerOf, type Make, type Said } from './program';

export type FromWorker = Said | { progress: string };
export interface ToWorker {
  program: 'engine' | 'theory';
  module: WebAssembly.Module;
  question: Record<string, unknown>;
  seconds: number;
}

/** What a Worker has, as far as it is used here. */
interface Place {
  importScripts(name: string): void;
  algaeEngine: Make;
  algaeTheory?: Make;
  postMessage(message: FromWorker, moved?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

const place = self as unknown as Place;
place.importScripts('engine.js'); // what emscripten writes beside engine.wasm
function makerOf(program: ToWorker['program']): Make {
  if (program === 'engine') return place.algaeEngine;
  if (!place.algaeTheory) place.importScripts('theory.js');
  return place.algaeTheory!;
}
place.onmessage = (event) => {
  const { program, module, question, seconds } = event.data;
  void answerOf(makerOf(program), module, question, seconds, (progress) => place.postMessage({ progress })).then((found) => place.postMessage(found, [found.bytes.buffer as ArrayBuffer]));
};
