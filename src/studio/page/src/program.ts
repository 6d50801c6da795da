// One question to the engine as WebAssembly. Each has an instance of its own, as each has a process of its own in the server: what goes
// wrong in one is gone with it. Runs in a Worker of the page and, for its test, in node.

export { firstQuestion } from './first';

export interface Program {
  FS: {
    writeFile(path: string, text: string): void;
    readFile(path: string): Uint8Array;
    open(path: string, flags: string): unknown;
    close(stream: unknown): void;
    mkdir(path: string): void;
    symlink(to: string, path: string): void;
    streams: unknown[];
  };
  callMain(words: string[]): number;
}
export type Make = (options: Record<string, unknown>) => Promise<Program>;

export interface Said {
  status: number;
  said: string;
  broken: boolean; // it ended in the middle
  bytes: Uint8Array;
}

export async function answerOf(make: Make, module: WebAssembly.Module, question: Record<string, unknown>, seconds: number, progress: (line: string) => void): Promise<Said> {
  const said: string[] = [];
  const program = await make({
    noInitialRun: true,
    thisProgram: 'algae',
    printErr: (line: string) => {
      said.push(line);
      progress(line);
    },
    instantiateWasm: (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => {
      void WebAssembly.instantiate(module, imports).then(done);
      return {};
    },
  });
  const { FS } = program;
  // The question is the standard input, and the standard output is a file: bytes, not lines.
  FS.writeFile('/question', JSON.stringify(question));
  FS.close(FS.streams[0]);
  FS.open('/question', 'r');
  FS.close(FS.streams[1]);
  FS.open('/answer', 'w+');
  try {
    const status = program.callMain(['studio', '--ask', '--timeout', String(seconds), '--max-memory', '900M']);
    return { status, said: said.join('\n'), broken: false, bytes: FS.readFile('/answer') };
  } catch (error) {
    return { status: 3, said: [...said, String(error)].join('\n'), broken: true, bytes: new Uint8Array(0) };
  }
}
