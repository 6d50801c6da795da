// What a page of static files does before its script is there (build.mjs puts it into the page): it makes a Worker, which loads the engine of
// figures, and asks for the first picture. The Worker has a thread of its own, while that of the page is busy with the script.

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

const worker = new Worker('worker.js', { name: 'first' });
const question = location.hash.length > 1 ? null : firstQuestion();
const module = new Promise<WebAssembly.Module>((found, fail) => {
  worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => 'module' in data && found(data.module));
  worker.addEventListener('error', fail);
});
const said = new Promise<Said>((found, fail) => {
  worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => 'bytes' in data && found(data));
  worker.addEventListener('error', fail);
});
const isFree = (question ? said : module).then(
  (found) => !('broken' in found && found.broken),
  () => false,
);
module.catch(() => undefined);
said.catch(() => undefined);
worker.postMessage({ program: 'engine', question: question && { ...question }, seconds: 30 } satisfies ToWorker);
Object.assign(window, { algaeEarly: { worker, module, question, said: question && said, isFree } satisfies Early });
