// The page without a server: what its engine says, and what it shows.
//
//     node static.mjs ALGAE FOLDER PICTURES [CHROMIUM]
//
// FOLDER has the page of static files (tools/studio --static). The engine, in node, and a studio of the command ALGAE get the same questions
// about ten systems, and their answers are compared: texts and whole numbers must be equal, other numbers to a millionth of the largest, as
// sines of the two machines differ in the last digit. Then Chromium opens the page, served as files, and what is on the screen is read.
import { mkdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { gzipSync } from 'node:zlib';
import { answerOf } from './built/program.mjs';
import { checks, startedStudio } from './driving.mjs';

const [algae, folder, pictures, executable] = process.argv.slice(2);
const { check, end } = checks();

process.setMaxListeners(0); // each instance of the engine listens to node's own troubles

// What takes part: the engine here, and the command.
const make = createRequire(import.meta.url)(`${folder}/engine.js`);
const module = await WebAssembly.compile(readFileSync(`${folder}/engine.wasm`));
const engineSays = (question) => answerOf(make, module, question, 60, () => {});
const { studio, address } = await startedStudio(algae, '--timeout', '120');
const commandSays = async (question) => {
  const response = await fetch(`${address.replace(/\/?$/, '/')}ask`, { method: 'POST', headers: { 'Content-Type': 'application/json', Origin: new URL(address).origin }, body: JSON.stringify(question) });
  let bytes = Buffer.from(await response.arrayBuffer());
  while (bytes[0] === 126) bytes = bytes.subarray(bytes.indexOf(10) + 1);
  const end = bytes.indexOf(10);
  const head = JSON.parse(bytes.subarray(0, end).toString());
  return { status: head.status, bytes: bytes.subarray(end + 1) };
};

/** The first difference of two values, or nothing. */
function difference(a, b, where = '') {
  if (typeof a === 'number' && typeof b === 'number') {
    if (a === b || (!(Number.isInteger(a) && Number.isInteger(b)) && Math.abs(a - b) <= 1e-6 * Math.max(1, Math.abs(a), Math.abs(b)))) return '';
    return `${where}: ${a} and ${b}`;
  }
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b ? '' : `${where}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`;
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  for (const key of keys) {
    const found = difference(a[key], b[key], `${where}.${key}`);
    if (found) return found;
  }
  return '';
}
/** The same of two figures: a line of JSON, then numbers. */
function figureDifference(a, b) {
  const parts = (bytes) => {
    const end = bytes.indexOf(10);
    return { head: JSON.parse(Buffer.from(bytes.subarray(0, end)).toString()), numbers: Buffer.from(bytes.subarray(end + 1)) };
  };
  const [one, other] = [parts(a), parts(b)];
  const said = difference(one.head, other.head);
  if (said) return said;
  if (one.numbers.length !== other.numbers.length) return `${one.numbers.length} bytes and ${other.numbers.length}`;
  const floats = one.head.kind === 'plane' ? 4 * one.head.strokes : 6 * (one.head.corners ?? 0);
  const size = Math.max(1, ...one.head.box.map(Math.abs));
  for (let i = 0; i < one.numbers.length / 4; ++i) {
    const [x, y] = i < floats ? [one.numbers.readFloatLE(4 * i), other.numbers.readFloatLE(4 * i)] : [one.numbers.readUInt32LE(4 * i), other.numbers.readUInt32LE(4 * i)];
    if (i < floats ? Math.abs(x - y) > 1e-6 * size : x !== y) return `number ${i}: ${x} and ${y}`;
  }
  return '';
}

const aboutGrowth = ['growth', 'factors', 'growth-latex'];
const systems = [
  ...['koch', 'plant-f', 'dragon-fx', 'honda-a', 'hilbert-3d', 'anabaena'].map((name) => ({ name })),
  { text: 'axiom a\na -> ab\nb -> a\n' },
  { text: 'axiom F\nF -> F[+F]F[-F]F : 1/3\nF -> F[+F]F : 1/3\nF -> F[-F]F : 1/3\nangle 25.7\n' },
  { text: 'axiom A(1)\nA(s) -> F(s)[+A(s/1.456)][-A(s/1.456)]\nangle 85\n' },
  { text: 'axiom baaaaaaaa\nb < a -> b\nb -> a\n', without: aboutGrowth }, // the page asks for growth without context
];
let compared = 0;
for (const { without = [], ...system } of systems)
  for (const question of ['describe', 'show', 'derivation', 'walk', 'figure', ...aboutGrowth].filter((one) => !without.includes(one))) {
    const asked = { question, ...system, ...(['derivation', 'walk', 'figure'].includes(question) ? { n: 3 } : {}) };
    const [engine, command] = [await engineSays(asked), await commandSays(asked)];
    const name = `${question} of ${system.name ?? JSON.stringify(system.text)}`;
    check(!engine.broken, `the engine ends ${name} as it should: ${engine.said}`);
    check(engine.status === command.status, `${name}: status ${engine.status} of the engine, ${command.status} of the command`);
    if (engine.broken || engine.status !== command.status) continue;
    const text = (bytes) => Buffer.from(bytes).toString();
    let found;
    if (question === 'figure' && engine.status === 0) found = figureDifference(engine.bytes, command.bytes);
    else if (question === 'growth-latex') found = text(engine.bytes) === text(command.bytes) ? '' : 'other text';
    else if (engine.bytes.length === 0 || command.bytes.length === 0) found = engine.bytes.length === command.bytes.length ? '' : 'one answer is empty';
    else found = difference(JSON.parse(text(engine.bytes)), JSON.parse(text(command.bytes)));
    check(found === '', `${name}: ${found}`);
    ++compared;
  }
check(compared === 77, `77 answers were compared, not ${compared}`);
console.log(`${compared} answers of the engine compared with those of the command`);
const wrong = await engineSays({ question: 'describe', text: 'axiom F\nF > FF\n' });
check(wrong.status === 2 && JSON.parse(Buffer.from(wrong.bytes).toString()).error.line === 2, 'a mistake has its line');
studio.kill();

// What a first visit loads.
let load = 0;
for (const file of ['index.html', 'worker.js', 'engine.js', 'engine.wasm']) {
  const size = gzipSync(readFileSync(`${folder}/${file}`), { level: 9 }).length;
  load += size;
  console.log(`${file}: ${size} bytes gzipped`);
}
console.log(`first load: ${load} bytes gzipped`);
check(load <= 2.5e6, `the first load is at most 2.5 MB gzipped, not ${load}`);

if (executable) {
  const { chromium } = await import('playwright-core');
  mkdirSync(pictures, { recursive: true });
  const kinds = { html: 'text/html', js: 'text/javascript', wasm: 'application/wasm' };
  const files = createServer((request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1).split(/[?#]/)[0];
    if (!['index.html', 'worker.js', 'engine.js', 'engine.wasm'].includes(name)) return response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': kinds[name.split('.')[1]] }).end(readFileSync(`${folder}/${name}`));
  });
  await new Promise((done) => files.listen(0, '127.0.0.1', done));
  const browser = await chromium.launch({ executablePath: executable, args: ['--no-sandbox', '--use-gl=swiftshader', '--enable-unsafe-swiftshader'] });
  const page = await browser.newPage({ viewport: { width: 1400, height: 860 }, colorScheme: 'light', locale: 'en-GB' });
  page.setDefaultTimeout(120_000);
  const said = [];
  page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
  page.on('pageerror', (error) => said.push(String(error)));
  const begun = Date.now();
  await page.goto(`http://127.0.0.1:${files.address().port}/`);
  await page.getByRole('img', { name: /256 segments/ }).waitFor();
  console.log(`first picture after ${Date.now() - begun} ms`);
  check(true, 'the figure of the first system is on the screen');
  await page.screenshot({ path: `${pictures}/static-figure.png` });
  await page.getByRole('tab', { name: 'Derivation' }).click();
  await page.getByText('F+F--F+F', { exact: false }).first().waitFor().catch(() => {});
  await page.locator('#right[aria-busy="false"]').waitFor();
  check(/ancestors|Click a letter/i.test(await page.locator('#panel-derivation').innerText()), 'the derivation is on the screen');
  await page.screenshot({ path: `${pictures}/static-derivation.png` });
  await page.getByRole('tab', { name: 'Growth' }).click();
  await page.getByRole('heading', { name: 'Growth' }).waitFor();
  check(/algae studio/.test(await page.locator('#panel-growth .graph').innerText()), 'the graph that is left out says why');
  await page.screenshot({ path: `${pictures}/static-growth.png` });
  for (const tab of ['Language', 'Claims', 'Dimension', 'Lessons']) check(/algae studio/.test((await page.getByRole('tab', { name: tab }).getAttribute('title')) ?? ''), `the tab ${tab} is grey and says why`);
  // A mistake has its line, and the figure follows its correction.
  await page.getByRole('tab', { name: 'Figure', exact: true }).click();
  const editor = page.getByRole('textbox', { name: /Editor/ });
  await editor.click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('axiom F\nF > FF\n');
  await page.locator('#about').getByText('line 2').waitFor();
  check(true, 'a mistake is said with its line');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('axiom F-F-F-F\nF -> F-F+F+FF-F-F+F\nangle 90\ngeneration 2\n');
  await page.getByRole('img', { name: /256 segments/ }).waitFor();
  await page.screenshot({ path: `${pictures}/static-typed.png` });
  check(said.length === 0, `the browser complains of nothing: ${said.join('; ')}`);
  await browser.close();
  files.close();
}
end();
