// The page without a server: what its engine says, and what it shows.
//
//     node static.mjs ALGAE FOLDER PICTURES [CHROMIUM]
//
// FOLDER has the page of static files (tools/studio --static). The engines, in node, and a studio of the command ALGAE get the same questions
// about ten systems, claims of the theory, and answers to the exercises of all lessons, and their answers are compared: texts and whole numbers must be equal, other numbers to a millionth of the largest, as
// sines of the two machines differ in the last digit. Then Chromium opens the page, served as files, and what is on the screen is read.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { relative } from 'node:path';
import { setTimeout as later } from 'node:timers/promises';
import { deflateRawSync, gzipSync } from 'node:zlib';
import { answerOf, firstQuestion } from './built/program.mjs';
import { checks, startedStudio } from './driving.mjs';

const [algae, folder, pictures, executable] = process.argv.slice(2);
const { check, end } = checks();

process.setMaxListeners(0); // each instance of the engine listens to node's own troubles

// What takes part: the engine here, and the command.
const require = createRequire(import.meta.url);
const programs = {};
for (const name of ['engine', 'theory']) programs[name] = { make: require(`${folder}/${name}.js`), module: await WebAssembly.compile(readFileSync(`${folder}/${name}.wasm`)) };
const engineSays = (question, name = 'engine', seconds = 60) => answerOf(programs[name].make, programs[name].module, question, seconds, () => {});
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

/** Asks both and compares; the engine of the theory has what the one of figures has, and must say the same. */
let compared = 0;
async function same(asked, name, programsAsked = ['engine', 'theory'], kind = 'json') {
  const command = await commandSays(asked);
  for (const program of programsAsked) {
    const engine = await engineSays(asked, program);
    check(!engine.broken, `the ${program} ends ${name} as it should: ${engine.said}`);
    check(engine.status === command.status, `${name}: status ${engine.status} of the ${program}, ${command.status} of the command: ${Buffer.from(engine.bytes).toString().slice(0, 200)}`);
    if (engine.broken || engine.status !== command.status) continue;
    const text = (bytes) => Buffer.from(bytes).toString();
    let found;
    if (kind === 'figure' && engine.status === 0) found = figureDifference(engine.bytes, command.bytes);
    else if (kind === 'start') found = difference(JSON.parse(text(engine.bytes)).claims, JSON.parse(text(command.bytes)).claims);
    else if (kind === 'text') found = text(engine.bytes) === text(command.bytes) ? '' : 'other text';
    else if (engine.bytes.length === 0 || command.bytes.length === 0) found = engine.bytes.length === command.bytes.length ? '' : 'one answer is empty';
    else found = difference(JSON.parse(text(engine.bytes)), JSON.parse(text(command.bytes)));
    check(found === '', `${name} by the ${program}: ${found}`);
    ++compared;
  }
}

const aboutGrowth = ['growth', 'factors', 'growth-latex'];
const systems = [
  ...['koch', 'plant-f', 'dragon-fx', 'honda-a', 'hilbert-3d', 'anabaena'].map((name) => ({ name })),
  { text: 'axiom a\na -> ab\nb -> a\n' },
  { text: 'axiom F\nF -> F[+F]F[-F]F : 1/3\nF -> F[+F]F : 1/3\nF -> F[-F]F : 1/3\nangle 25.7\n' },
  { text: 'axiom A(1)\nA(s) -> F(s)[+A(s/1.456)][-A(s/1.456)]\nangle 85\n' },
  { text: 'axiom baaaaaaaa\nb < a -> b\nb -> a\n' },
];
for (const system of systems) {
  const name = system.name ?? JSON.stringify(system.text);
  for (const question of ['describe', 'show', 'derivation', 'walk', 'figure', ...aboutGrowth]) {
    if (system === systems[9] && aboutGrowth.includes(question)) continue; // the page does not ask for growth with context
    const kind = question === 'figure' ? 'figure' : question === 'growth-latex' ? 'text' : 'json';
    await same({ question, ...system, ...(['derivation', 'walk', 'figure'].includes(question) ? { n: 3 } : {}) }, `${question} of ${name}`, ['engine', 'theory'], kind);
  }
  for (const question of ['finite', 'dimension']) await same({ question, ...system, ...(question === 'dimension' ? { n: 3 } : {}) }, `${question} of ${name}`, ['theory']);
  await same({ question: 'list', ...system, longest: 5 }, `list of ${name}`, ['theory']);
  for (const word of ['abaab', 'F', 'ab']) await same({ question: 'member', ...system, word }, `${word} in ${name}`, ['theory']);
}
// Claims: the theory's own that end soon, a search, and what is wrong with one.
await same({ question: 'start' }, 'start', ['theory'], 'start');
const root = new URL('../..', import.meta.url).pathname;
const claims = ['finite', 'decidable'].flatMap((part) => readdirSync(`${root}theory/${part}`).filter((file) => file.endsWith('.claim')).sort().map((file) => `theory/${part}/${file}`)).slice(0, 20);
for (const path of claims) {
  await same({ question: 'open', from: 'theory', file: path }, `the text of ${path}`, ['theory']);
  await same({ question: 'check', text: readFileSync(root + path, 'utf8') }, `the claim ${path}`, ['theory']);
}
await same({ question: 'check', text: 'claim  Search\ntheorem for all 0L languages A, B: A | B is 0L\n' }, 'a search', ['theory']);
await same({ question: 'check', text: 'claim  Wrong\nshow A is\n' }, 'a claim with a mistake', ['theory']);
// Lessons and their exercises, with the answers that are known to be right, and with one that is not.
await same({ question: 'lessons' }, 'the list of lessons', ['theory']);
const answers = readdirSync(`${root}lessons/answers`).filter((file) => /^\d\d-\d\.\w+$/.test(file)).sort();
for (const file of answers) {
  const [lesson, exercise] = [Number(file.slice(0, 2)), Number(file[3])];
  if (exercise === 1) await same({ question: 'lesson', lesson }, `lesson ${lesson}`, ['theory']);
  await same({ question: 'mark', lesson, exercise, text: readFileSync(`${root}lessons/answers/${file}`, 'utf8') }, `the answer ${file}`, ['theory']);
  await same({ question: 'mark', lesson, exercise, text: 'axiom zz\n' }, `a wrong answer to ${file}`, ['theory']);
}
const own = { exercise_text: 'exercise Doubling\ntask Double.\nanswer system\nshow growth(answer) = 2^n\n', file: 'mine.exercise' };
await same({ question: 'exercise', ...own }, 'an exercise of one\'s own', ['theory']);
await same({ question: 'mark', ...own, text: 'axiom a\na -> aa\n' }, 'an answer to it', ['theory']);
// What an editor asks.
for (const method of ['diagnostics', 'completion', 'hover', 'formatting'])
  for (const [kind, text] of [['lsys', 'axiom F\nF -> F+\nangel 60\n'], ['claim', 'claim  One\nshow a in {a}\nshw b in {a}\n']]) await same({ question: 'editor', kind, method, text, line: 2, character: 3 }, `${method} of a ${kind}`, ['theory'], 'text');
// A certificate of the engine is one that the command's checker accepts.
const certificate = await engineSays({ question: 'certificate', text: 'claim  Proved\nlet A = {a, aa}\nshow A is not 0L\n' }, 'theory');
const checked = spawnSync(algae, ['verify', '-'], { input: Buffer.from(certificate.bytes), encoding: 'utf8' });
check(checked.status === 0, `verify accepts a certificate of the engine: ${checked.stdout}${checked.stderr}`);
// Work that does not end is ended by its time.
const begunAt = performance.now();
const long = await engineSays({ question: 'check', text: 'claim  Long\ntheorem for all 0L languages A, B: A B is EDT0L\n', instances: 1e9 }, 'theory', 2);
check(long.status === 3 && performance.now() - begunAt < 30_000, `a search ends with its time: status ${long.status} after ${Math.round(performance.now() - begunAt)} ms`);
const expected = 2 * 77 + 10 * 6 + 1 + 2 * claims.length + 2 + 1 + 14 + 2 * answers.length + 2 + 8;
check(compared === expected && claims.length === 20 && answers.length > 40, `${expected} answers were compared, not ${compared}`);
console.log(`${compared} answers of the engines compared with those of the command`);
const wrong = await engineSays({ question: 'describe', text: 'axiom F\nF > FF\n' });
check(wrong.status === 2 && JSON.parse(Buffer.from(wrong.bytes).toString()).error.line === 2, 'a mistake has its line');
studio.kill();

// What the files have for bytes.
const names = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((one) => one.isFile()).map((one) => relative(folder, `${one.parentPath ?? one.path}/${one.name}`));
const sizes = Object.fromEntries(names.map((file) => [file, gzipSync(readFileSync(`${folder}/${file}`), { level: 9 }).length]));
const sizeOf = (files) => files.reduce((sum, file) => sum + sizes[file], 0);
for (const [file, size] of Object.entries(sizes)) console.log(`${String(size).padStart(9)} bytes gzipped: ${file}`);

if (executable) {
  const { chromium } = await import('playwright-core');
  mkdirSync(pictures, { recursive: true });
  const kinds = { html: 'text/html', js: 'text/javascript', wasm: 'application/wasm' };
  const served = [];
  let frame = ''; // of a page of somebody else's
  const files = createServer((request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1).split(/[?#]/)[0];
    if (name === 'other') return response.writeHead(200, { 'Content-Type': 'text/html' }).end(`<!DOCTYPE html><html lang="en"><title>Other</title><link rel="icon" href="data:,"><h1>Other</h1>${frame}</html>`);
    if (!(name in sizes)) return response.writeHead(404).end();
    served.push(name);
    response.writeHead(200, { 'Content-Type': kinds[name.split('.').pop()] }).end(readFileSync(`${folder}/${name}`));
  });
  await new Promise((done) => files.listen(0, '127.0.0.1', done));
  const address = `http://127.0.0.1:${files.address().port}/`;
  const browser = await chromium.launch({ executablePath: executable, args: ['--no-sandbox', '--use-gl=swiftshader', '--enable-unsafe-swiftshader'] });
  const context = await browser.newContext({ viewport: { width: 1400, height: 860 }, colorScheme: 'light', locale: 'en-GB' });
  const page = await context.newPage();
  context.setDefaultTimeout(120_000);
  const said = [];
  context.on('console', (message) => message.type() === 'error' && said.push(message.text()));
  context.on('weberror', (error) => said.push(String(error.error())));
  // How long a first picture takes, each time in a browser that has nothing of the page: from the beginning of the navigation to the frame.
  // Meanwhile nobody asks the page anything: to look for an element, Playwright first has a script of its own read there.
  // The system of the page itself, whose figure comes with the page, and one of a link, whose figure the engine makes.
  const linked = deflateRawSync(JSON.stringify({ text: 'axiom F-F-F-F\nF -> F-F+F+FF-F-F+F\nangle 90\ngeneration 2\n', kind: 'system' })).toString('base64url');
  const times = { own: [], linked: [] };
  const median = (name) => times[name].sort((a, b) => a - b)[3];
  for (let i = 0; i < 14; ++i) {
    const fresh = await browser.newContext({ viewport: { width: 1400, height: 860 } });
    const first = await fresh.newPage();
    await first.goto(i % 2 === 0 ? address : `${address}#${linked}`);
    do await later(2000);
    while ((await first.evaluate(() => window.algaeFigurePainted())) === 0);
    times[i % 2 === 0 ? 'own' : 'linked'].push(Math.round(await first.evaluate(() => window.algaeFigurePainted())));
    await first.getByRole('img', { name: /256 segments/ }).waitFor();
    if (i === 0) {
      const came = Buffer.from(await first.evaluate(async () => [...(await algaeEarly.said).bytes]));
      for (const pixels of [64, 1400, 16384]) {
        const made = await engineSays(firstQuestion(pixels));
        check(made.status === 0 && came.equals(Buffer.from(made.bytes)), `the first picture is what the engine makes for ${pixels} pixels`);
      }
    }
    await fresh.close();
  }
  const load = sizeOf([...new Set(served)]);
  console.log(`first load: ${load} bytes gzipped; the theory: ${sizeOf(['theory.js', 'theory.wasm'])} more`);
  check(load > 1e6 && load <= 2.5e6, `the first load is at most 2.5 MB gzipped, not ${load}`);
  console.log(`first picture after ${median('own')} ms, the median of ${times.own.join(', ')}`);
  console.log(`of a system in a link after ${median('linked')} ms, the median of ${times.linked.join(', ')}`);
  check(!served.includes('theory.wasm'), 'a first picture does not load the engine of the theory');
  const settled = () => page.waitForFunction(() => !document.querySelector('[aria-busy="true"]'));
  const panel = async () => {
    await settled();
    return page.locator('[role=tabpanel]:not([hidden])').innerText();
  };
  const tab = async (name) => {
    await page.getByRole('tab', { name, exact: true }).click();
    return panel();
  };
  const type = async (text) => {
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(text);
    await settled();
  };
  const sees = async (text, what) => check(await page.getByText(text).filter({ visible: true }).first().waitFor().then(() => true, () => false), what);
  const picture = async (name) => {
    await settled();
    await page.screenshot({ path: `${pictures}/static-${name}.png` });
  };
  await page.goto(address);
  await page.getByRole('img', { name: /256 segments/ }).waitFor();
  check(true, 'the figure of the first system is on the screen');
  const exports = page.getByLabel('Export');
  check((await exports.isDisabled()) && /algae studio/.test((await exports.getAttribute('title')) ?? ''), 'files of pictures, which are left out, are grey and say why');
  await picture('figure');
  await tab('Derivation');
  await page.getByText('F+F--F+F', { exact: false }).first().waitFor().catch(() => {});
  check(/ancestors|Click a letter/i.test(await panel()), 'the derivation is on the screen');
  await picture('derivation');
  await tab('Growth');
  await page.getByRole('heading', { name: 'Growth' }).waitFor();
  check(/algae studio/.test(await page.locator('#panel-growth .graph').innerText()), 'the graph that is left out says why');
  await picture('growth');
  // A mistake has its line before the theory is there, and the figure follows its correction.
  await tab('Figure');
  await type('axiom F\nF > FF\n');
  await page.locator('#about').getByText('line 2').waitFor();
  check(true, 'a mistake is said with its line');
  check(!served.includes('theory.wasm'), 'a mistake does not load the engine of the theory');
  await type('axiom F-F-F-F\nF -> F-F+F+FF-F-F+F\nangle 90\ngeneration 2\n');
  await page.getByRole('img', { name: /256 segments/ }).waitFor();
  await picture('typed');
  // The tabs of the theory.
  await tab('Language');
  await page.getByPlaceholder('abaab').fill('F-F-F-F');
  check(/F-F-F-F is in the language/.test(await panel()), 'a word is in the language');
  check(served.includes('theory.wasm'), 'a question about the language loads the engine of the theory');
  await picture('language');
  check(/Exact dimension/.test(await tab('Dimension')), 'the exact dimension is said');
  check((await page.locator('#panel-dimension .dot').count()) > 3, 'the boxes are counted');
  await picture('dimension');
  await tab('Claims');
  await sees('A | B is not 0L', 'a claim is checked');
  check(/✓ proved/.test(await panel()), 'the claim is proved');
  await picture('claims');
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save certificate' }).click()]);
  const kept = spawnSync(algae, ['verify', '-'], { input: readFileSync(await file.path()), encoding: 'utf8' });
  check(kept.status === 0, `verify accepts the certificate of the page: ${kept.stdout}${kept.stderr}`);
  await type('claim  Search\ntheorem for all 0L languages A, B: A | B is 0L\n');
  check(/counterexample: A = \{a\}, B = \{aa\}/.test(await panel()), 'a counterexample is found by search');
  await type('claim  One\nshw a in {a}\n');
  await page.locator('#about').getByText('line 2').waitFor();
  check(true, 'a mistake in a claim is said with its line');
  // A search is stopped by the button, which ends its Worker; the next question gets another one.
  await type('claim  Long\ntheorem for all 0L languages A, B: A B is EDT0L\n');
  await page.getByLabel('instances').fill('100000000');
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  const working = async () => page.workers().length;
  check((await working()) > 0, 'a search has a Worker');
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await sees('Stopped.', 'a search is stopped by the button');
  await type('claim  Proved\nlet A = {a, aa}\nshow A is not 0L\n');
  check(/✓ proved/.test(await panel()), 'after a stop the next claim is checked');
  await tab('Lessons');
  await type('aba\n');
  await page.getByRole('button', { name: 'Mark my answer' }).first().click();
  check(/✗ wrong|✓ right/.test(await panel()), 'an answer is marked');
  await picture('lessons');
  await page.setInputFiles('input[type=file]', { name: 'word.exercise', mimeType: 'text/plain', buffer: Buffer.from('exercise A word\ntask Write aa.\nanswer word\nshow answer == {aa}\n') });
  await sees('Task word: A word', 'an exercise of one\'s own opens');
  await type('aa\n');
  await page.getByRole('button', { name: 'Mark my answer' }).first().click();
  check(/✓ right/.test(await panel()), 'the answer to an exercise of one\'s own is marked');
  // Another page shows a figure, and a claim with its verdict, in a frame.
  for (const [name, expected] of [['Figure', /256 segments/], ['Claims', '✓ proved']]) {
    await tab(name);
    await page.getByRole('button', { name: 'Embed', exact: true }).click();
    frame = await page.getByLabel('HTML for another page').inputValue();
    await page.getByRole('button', { name: 'Close', exact: true }).click();
    const other = await context.newPage();
    await other.goto(`${address}other`);
    const inside = other.frameLocator('iframe');
    await inside.getByText(expected).filter({ visible: true }).first().waitFor();
    check(!(await inside.locator('.cm-content').isVisible()), `the frame of ${name} shows no editor`);
    await other.screenshot({ path: `${pictures}/static-embedded-${name.toLowerCase()}.png` });
    await other.close();
  }
  check(said.length === 0, `the browser complains of nothing: ${said.join('; ')}`);
  await browser.close();
  files.close();
}
end();
