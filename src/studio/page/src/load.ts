// An engine of the page of static files, for the page and for its Workers.

/** Compiled while it comes, where the server of the files says what it is. */
export async function load(file: string): Promise<WebAssembly.Module> {
  const response = await fetch(file);
  if (!response.ok) throw new Error(response.statusText);
  if (response.headers.get('Content-Type') === 'application/wasm') return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
