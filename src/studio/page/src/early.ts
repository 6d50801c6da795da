// What a page of static files does before its script is there (build.mjs puts it into the page): it makes a Worker, which loads the engine of
// figures. The answer that is the first picture stands here, as the engine gave it when the page was made; on a screen for which that is not
// fine enough the Worker is asked. The Worker has a thread of its own, while that of the page is busy with the script.

import { firstQuestion, type FirstQuestion } from './first';
import type { Said } from './program';
import type { FromWorker, ToWorker } from './worker';

export interface Early {
  worker: Worker;
  module: Promise<WebAssembly.Module>;
  question: FirstQuestion | null; // a link has another one
  said: Promise<Said> | null; // its answer
  isFree: Promise<boolean>; // what became of the Worker: it can have the next question, or it is broken
}

/** The engine's answer to the first question, for a screen with so many pixels a side; its bytes in base 64. */
declare const algaeFirst: { status: number; said: string; pixels: number; bytes: string };

const worker = new Worker('worker.js', { name: 'first' });
const question = location.hash.length > 1 ? null : firstQuestion();
const module = new Promise<WebAssembly.Module>((found, fail) => {
  worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => 'module' in data && found(data.module));
  worker.addEventListener('error', fail);
});
const isThere = question !== null && question.pixels <= algaeFirst.pixels;
const asked = isThere ? null : question; // of the Worker
const answered = new Promise<Said>((found, fail) => {
  worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => 'bytes' in data && found(data));
  worker.addEventListener('error', fail);
});
const isFree = (asked ? answered : module).then(
  (found) => !('broken' in found && found.broken),
  () => false,
);
module.catch(() => undefined);
answered.catch(() => undefined);
worker.postMessage({ program: 'engine', question: asked && { ...asked }, seconds: 30 } satisfies ToWorker);
const { status, said, bytes } = algaeFirst;
const first = (): Said => ({ status, said, broken: false, bytes: Uint8Array.from(atob(bytes), (byte) => byte.charCodeAt(0)) });
Object.assign(window, { algaeEarly: { worker, module, question, said: isThere ? Promise.resolve(first()) : asked && answered, isFree } satisfies Early });
