// Makes one file of the page: what it needs stands in it, and it loads nothing.
import { build } from 'esbuild';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';

const target = process.argv[2] ?? '../built';
const made = await build({
  entryPoints: ['src/main.ts'],
  bundle: true,
  minify: true,
  charset: 'utf8',
  format: 'iife',
  target: 'es2022',
  legalComments: 'none',
  metafile: true,
  write: false,
});
const script = made.outputFiles[0].text.replaceAll('</script', '<\\/script');
const style = readFileSync('src/style.css', 'utf8');
const page = readFileSync('src/page.html', 'utf8')
  .replace('/* style */', () => style)
  .replace('/* script */', () => script);
mkdirSync(target, { recursive: true });
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
