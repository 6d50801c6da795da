// What the page shows, who wants to know when that changes, and the link that holds it.

import { firstSystem } from './first';

export type Kind = 'system' | 'claim' | 'answer';
export type Tab = 'figure' | 'derivation' | 'growth' | 'language' | 'claims' | 'dimension' | 'lessons';
export const tabs: Tab[] = ['figure', 'derivation', 'growth', 'language', 'claims', 'dimension', 'lessons'];

export interface State {
  system: string;
  claim: string;
  answer: string;
  file: string;
  tab: Tab;
  n: number | null; // null: what the system shows
  seed: number | null;
  word: string;
  lesson: number; // 0: the exercises of a pack
  pack: PackedExercise[];
  embed: boolean;
}

/** An exercise of somebody's own, as its file says it. */
export interface PackedExercise {
  file: string;
  text: string;
}

const claim = `claim  A union of two 0L languages that is not one
let A = {a}
let B = {aa}
show A is 0L
show B is 0L
show A | B is not 0L
`;

export const state: State = {
  system: firstSystem,
  claim,
  answer: '',
  file: 'koch.lsys',
  tab: 'figure',
  n: null,
  seed: null,
  word: '',
  lesson: 1,
  pack: [],
  embed: false,
};

/** What the server says of the system; null while the system has a mistake. */
export interface Description {
  name: string;
  title: string;
  source: string;
  class: string;
  generations: [number, number] | null;
  seeds: [number, number] | null;
  angle: { value: number; written: string } | null;
  constants: { name: string; written: string; value: number }[];
  shape: boolean;
  d0l: boolean;
  chance: boolean;
  space: boolean;
}

type Listener = (changed: Set<keyof State | 'description'>) => void;
const listeners: Listener[] = [];
let description: Description | null = null;

export function listen(listener: Listener): void {
  listeners.push(listener);
}

export function change(values: Partial<State>): void {
  const changed = new Set<keyof State | 'description'>();
  for (const key of Object.keys(values) as (keyof State)[])
    if (state[key] !== values[key]) {
      (state as unknown as Record<string, unknown>)[key] = values[key];
      changed.add(key);
    }
  if (changed.size > 0) for (const listener of listeners) listener(changed);
}

export function describe(found: Description | null): void {
  description = found;
  for (const listener of listeners) listener(new Set(['description']));
}

export function described(): Description | null {
  return description;
}

/** The generation that is shown. */
export function shownGeneration(): number {
  return state.n ?? description?.generations?.[1] ?? 3;
}

/** The fields of a question about the system. */
export function systemQuestion(question: string, more: Record<string, unknown> = {}): Record<string, unknown> {
  return { question, text: state.system, ...more };
}

export function withGeneration(question: string, more: Record<string, unknown> = {}): Record<string, unknown> {
  const fields = systemQuestion(question, more);
  if (state.n !== null) fields['n'] = state.n; // otherwise the server knows which one the system shows
  if (state.seed !== null) fields['seed'] = state.seed;
  return fields;
}

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const body = new Response(bytes as BlobPart).body!.pipeThrough(stream as unknown as ReadableWritablePair<Uint8Array, Uint8Array>);
  return new Uint8Array(await new Response(body as unknown as ReadableStream<Uint8Array>).arrayBuffer());
}

/** How a figure is looked at: the middle of the view and how wide it is, in the units of the figure; the turtle's step; the camera in space. */
export interface Look {
  view?: number[];
  step?: number;
  camera?: number[];
}

function lookOf(found: unknown): Look | null {
  if (typeof found !== 'object' || found === null) return null;
  const { view, step, camera } = found as Record<string, unknown>;
  const numbers = (value: unknown, count: number): value is number[] => Array.isArray(value) && value.length === count && value.every(Number.isFinite);
  const look: Look = {};
  if (numbers(view, 3) && view[2]! > 0) look.view = view;
  if (Number.isSafeInteger(step) && (step as number) >= 0) look.step = step as number;
  if (numbers(camera, 6)) look.camera = camera;
  return look;
}

function packOf(found: unknown): PackedExercise[] | null {
  if (!Array.isArray(found)) return null;
  const pack = found.map((one: unknown) => one as Partial<PackedExercise> | null);
  if (!pack.every((one) => typeof one?.file === 'string' && typeof one.text === 'string')) return null;
  return pack.map((one) => ({ file: one!.file!, text: one!.text! }));
}

/** The part of an address that holds all of it: the state as JSON, deflated, in letters that addresses may have. `other` replaces some of it. */
export async function toLink(look: Look | null, other: Partial<State> = {}): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify({ ...state, ...other, look })), new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** Takes over what a link holds, and says how its figure is looked at; what is no link changes nothing. */
export async function fromLink(link: string, looks: (look: Look) => void): Promise<boolean> {
  try {
    const text = atob(link.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
    const found = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw')))) as Record<string, unknown>;
    const values: Record<string, unknown> = {};
    for (const [key, value] of Object.entries(state)) {
      const given = found[key];
      if (given === undefined) continue;
      const isNumber = key === 'n' || key === 'seed';
      if (key === 'pack') {
        const pack = packOf(given);
        if (pack) values[key] = pack;
      } else if (isNumber ? given === null || (Number.isSafeInteger(given) && (given as number) >= 0) : typeof given === typeof value) values[key] = given;
    }
    if (!tabs.includes((values['tab'] ?? 'figure') as Tab)) delete values['tab'];
    const look = lookOf(found['look']);
    if (look) looks(look);
    change(values as Partial<State>);
    return true;
  } catch {
    return false;
  }
}
