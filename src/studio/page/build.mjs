// Makes one file of the page: what it needs stands in it, and it loads nothing.
//
//     node build.mjs FOLDER           page.html and LICENCES.txt, as the command carries them
//     node build.mjs FOLDER static    the page in parts, which go beside the engines of tools/engine; built/program.mjs for their test
import { build, transform } from 'esbuild';
import { createRequire } from 'node:module';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';

const target = process.argv[2] ?? '../built';
const isStatic = process.argv[3] === 'static';
// The page of static files has no graph of letters (src/engine.ts), so it does without Graphviz, half of the page's bytes.
const withoutGraphviz = {
  name: 'without Graphviz',
  setup(made) {
    made.onResolve({ filter: /^@viz-js\/viz$/ }, () => ({ path: 'none', namespace: 'none' }));
    made.onLoad({ filter: /.*/, namespace: 'none' }, () => ({ contents: "export const instance = () => Promise.reject(new Error('Graphviz is left out'));" }));
  },
};
// What lines begin with, as the editors of others know it (algae lsp --editors).
const words = ['lsys', 'claim'].flatMap((kind) => {
  const line = readFileSync(`../../docs/editors/vim/syntax/${kind}.vim`, 'utf8').split('\n').find((one) => one.startsWith(`syntax match ${kind}Keyword`));
  return line.split('@<=\\%(')[1].split('\\)')[0].split('\\|');
});
const define = { algaeKeywords: JSON.stringify([...new Set(words)].join('|')) };
const shared = { define, bundle: true, minify: true, charset: 'utf8', target: 'es2022', legalComments: 'none' };
const style = readFileSync('src/style.css', 'utf8');
const frame = readFileSync('src/page.html', 'utf8').replace('/* style */', () => style);
mkdirSync(target, { recursive: true });
if (isStatic) {
  // The same page, which asks Workers. What a first picture does without, three.js and KaTeX, are files of their own.
  rmSync(`${target}/parts`, { recursive: true, force: true });
  const { metafile } = await build({ ...shared, metafile: true, plugins: [withoutGraphviz], entryPoints: { page: 'src/main.ts' }, format: 'esm', splitting: true, outdir: target, chunkNames: 'parts/[name]-[hash]' });
  // The engine's side of it for the page and, as a module, for its test in node.
  // What emscripten writes beside engine.wasm stands in the Worker's script, behind what begins to load that.
  const worker = (await build({ ...shared, entryPoints: ['src/worker.ts'], format: 'iife', write: false })).outputFiles[0].text;
  writeFileSync(`${target}/worker.js`, worker + (await transform(readFileSync(`${target}/engine.js`, 'utf8'), { minify: true, legalComments: 'none' })).code);
  await build({ ...shared, entryPoints: ['src/program.ts'], format: 'esm', outfile: 'built/program.mjs' });
  // A Worker loads the engine of figures while the page's script is still read.
  // The first picture itself the engine makes here, in the detail of the largest screens.
  const { answerOf, firstQuestion } = await import(`${process.cwd()}/built/program.mjs`);
  const pixels = 16384;
  const engine = await WebAssembly.compile(readFileSync(`${target}/engine.wasm`));
  const first = await answerOf(createRequire(import.meta.url)(`${target}/engine.js`), engine, firstQuestion(pixels), 60, () => {});
  if (first.status !== 0) throw new Error(`the first picture: ${first.said}`);
  const found = { algaeFirst: JSON.stringify({ status: first.status, said: first.said, pixels, bytes: Buffer.from(first.bytes).toString('base64') }) };
  const early = (await build({ ...shared, define: found, entryPoints: ['src/early.ts'], format: 'iife', write: false })).outputFiles[0].text;
  const own = Object.values(metafile.outputs).find((one) => one.entryPoint === 'src/main.ts');
  const preloads = own.imports.filter((one) => one.kind === 'import-statement').map((one) => `<link rel="modulepreload" href="parts/${one.path.split('/').pop()}">\n`);
  const loading = `<script>
${early}</script>
<script type="module" src="page.js"></script>
${preloads.join('')}`;
  writeFileSync(`${target}/index.html`, frame.replace('<html lang="en">', '<html lang="en" data-engine="static">').replace('<style>', () => `${loading}<style>`).replace(/<script>\s*\/\* script \*\/\s*<\/script>\n/, ''));
  process.exit(0);
}
const made = await build({ ...shared, entryPoints: ['src/main.ts'], format: 'iife', metafile: true, write: false });
const script = made.outputFiles[0].text.replaceAll('</script', '<\\/script');
const page = frame.replace('/* script */', () => script);
writeFileSync(`${target}/page.html`, page);

// Who made the parts that are in it, with their licences, and how many bytes each takes.
const bytes = new Map();
for (const [path, part] of Object.entries(Object.values(made.metafile.outputs)[0].inputs)) {
  const found = path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
  const name = found ? found[1] : 'algae';
  bytes.set(name, (bytes.get(name) ?? 0) + part.bytesInOutput);
}
let licences = 'The page of algae studio holds these packages, whole or in part.\n';
for (const name of [...bytes.keys()].sort()) {
  if (name === 'algae') continue;
  const about = JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8'));
  licences += `\n${name} ${about.version}: ${about.license}, ${bytes.get(name)} bytes\n`;
  for (const file of ['LICENSE', 'LICENSE.md', 'LICENCE', 'license'])
    try {
      licences += readFileSync(`node_modules/${name}/${file}`, 'utf8').trim().replace(/^/gm, '    ').trimEnd() + '\n';
      break;
    } catch {}
  if (name === '@viz-js/viz')
    licences += '    It holds Graphviz (Eclipse Public License 1.0, https://graphviz.org/license/) and Expat (MIT) as WebAssembly.\n';
}
writeFileSync(`${target}/LICENCES.txt`, licences);
console.log(`page.html: ${page.length} characters`);
for (const [name, size] of [...bytes].sort((a, b) => b[1] - a[1])) console.log(`${String(size).padStart(9)}  ${name}`);
