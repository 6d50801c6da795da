// Elements, in few words.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as (event: Event) => void);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  for (const child of children) if (child) element.append(child);
}

export function el<K extends keyof HTMLElementTagNameMap>(name: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  fill(element, attributes, children);
  return element;
}

export function svg(name: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  fill(element, attributes, children);
  return element;
}

/** Says something to screen readers. */
export function speak(text: string): void {
  const spoken = document.getElementById('spoken');
  if (spoken) spoken.textContent = text;
}

export function download(bytes: Uint8Array | string, name: string, type = 'application/octet-stream'): void {
  const address = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  el('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

const busyParts = new Map<string, number>();

/** Says of a part of the page, by its id, that it is not yet what it will be; the function that is returned takes that back. */
export function busy(part: string): () => void {
  const count = (by: number): void => {
    const now = (busyParts.get(part) ?? 0) + by;
    busyParts.set(part, now);
    document.getElementById(part)?.setAttribute('aria-busy', String(now > 0));
  };
  count(1);
  let over = false;
  return () => {
    if (!over) count(-1);
    over = true;
  };
}

/** The colours of the page as it looks now. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

export function later(milliseconds: number): Promise<void> {
  return new Promise((done) => setTimeout(done, milliseconds));
}
