// Drives the page in Chromium as a person would, and reads what is on the screen.
//
//     node test.mjs ALGAE PICTURES [CHROMIUM [quick]]
//
// starts the studio of the command ALGAE, goes through all tabs with ten systems, ten claims and ten lessons, and compares what the
// accessibility tree of the browser holds with what the command says of the same; with `quick`, through fewer of them. Pictures of each tab go to the folder PICTURES. It
// exits with 1 if something that should be there is not.
//
// Nothing here waits for a time: a step ends when the page says that it is not busy any more (aria-busy), or when the text that is
// waited for is there. The one limit is how long a page may be busy before the run gives up, which is far from what it takes on a busy machine.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { inflateRawSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { checks, startedStudio } from './driving.mjs';

const [algae, pictures, executable = '/usr/bin/chromium', amount] = process.argv.slice(2);
const isQuick = amount === 'quick'; // fewer systems, claims and lessons, no other languages, no dark page
const root = new URL('../..', import.meta.url).pathname;
const patience = 180_000; // milliseconds
const many = isQuick ? 2 : 10;
mkdirSync(pictures, { recursive: true });

const { check, end } = checks();
/** What the command says. */
const say = (words, input = '') => {
  const done = spawnSync(algae, words, { input, encoding: 'utf8', maxBuffer: 1 << 28 });
  if (done.error) throw done.error;
  return done.stdout;
};
const sayJson = (words, input) => JSON.parse(say([...words, '--json'], input));

const folder = mkdtempSync(`${tmpdir()}/algae-page-`);
const { studio, address } = await startedStudio(algae, folder, '--timeout', '120');
check((await (await fetch(address)).text()) === readFileSync('built/page.html', 'utf8'), 'the command serves the page that its sources make');

const browser = await chromium.launch({ executablePath: executable, args: ['--no-sandbox', '--use-gl=swiftshader', '--enable-unsafe-swiftshader'] });
const context = await browser.newContext({ viewport: { width: 1400, height: 860 }, colorScheme: 'light' });
context.setDefaultTimeout(patience);
const page = await context.newPage();
const said = [];
page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
page.on('pageerror', (error) => said.push(String(error)));
const foreign = [];
page.on('request', (request) => {
  if (!request.url().startsWith(address) && !request.url().startsWith('data:') && !request.url().startsWith('blob:')) foreign.push(request.url());
});
const devtools = await context.newCDPSession(page);
await devtools.send('Accessibility.enable');

/** Ends when nothing on the page is busy. */
const settled = (where = page) => where.waitForFunction(() => !document.querySelector('[aria-busy="true"]'), null, { timeout: patience });
const frame = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const picture = async (name) => {
  await settled();
  await frame();
  await page.screenshot({ path: `${pictures}/${name}.png` });
};

/** What a screen reader meets in a part of the page: names and texts of the browser's accessibility tree, in order. */
async function heard(role, name = null) {
  const { nodes } = await devtools.send('Accessibility.getFullAXTree');
  const all = new Map(nodes.map((node) => [node.nodeId, node]));
  const top = nodes.find((node) => !node.ignored && node.role?.value === role && (name === null || node.name?.value === name));
  const texts = [];
  const walk = (node) => {
    if (!node || node.role?.value === 'InlineTextBox') return;
    const parts = (node.childIds ?? []).map((id) => all.get(id));
    const isSaidBelow = parts.some((part) => part && part.role?.value !== 'InlineTextBox' && part.name?.value === node.name?.value);
    if (!node.ignored && node.name?.value && !isSaidBelow) texts.push(node.name.value);
    for (const id of node.childIds ?? []) walk(all.get(id));
  };
  walk(top);
  return texts.join(' ').replace(/[\u202f\u00a0]/g, ' ').replace(/\s+/g, ' ');
}
/** The panel that is shown, once it is not busy. */
async function panel() {
  await settled();
  return heard('tabpanel');
}
const without = (text) => text.replace(/\s+/g, '');
const includes = (text, part, what) => check(without(text).includes(without(part)), `${what}: expected ${JSON.stringify(part)} in ${JSON.stringify(text.slice(0, 300))}`);

const tab = async (name) => {
  await page.getByRole('tab', { name, exact: true }).click();
  return panel();
};
const sees = async (text, what) => {
  const is = await page.getByText(text).filter({ visible: true }).first().waitFor().then(() => true, () => false);
  check(is, what);
};
/** Puts a text into the editor, as one types it, and waits until the page has taken it in. */
const type = async (text) => {
  const there = () => page.evaluate(() => [...document.querySelectorAll('.cm-line')].map((line) => line.textContent).join('\n'));
  if ((await there()) === text) return settled(); // to wait for it would not tell when it is typed
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
  await page.waitForFunction((wanted) => [...document.querySelectorAll('.cm-line')].map((line) => line.textContent).join('\n') === wanted, text);
  await settled();
};

// Each system with what the command does not say in one word: segments of its figure, a word of its language and one that is none.
const systems = {
  koch: { text: 'axiom F\nF -> F+F--F+F\nangle 60\ngeneration 4\n', segments: '256', member: 'F+F--F+F', stranger: 'F+F', dimension: 'Exact dimension: log 4 / log 3' },
  plant: { text: 'axiom X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\nangle 22.5\nstart 0 0 90\ngeneration 4\n', segments: '360', member: 'X', stranger: 'XX' },
  dragon: { text: 'axiom FX\nX -> X+YF+\nY -> -FX-Y\nangle 90\ngeneration 7\n', segments: '128', member: 'FX+YF+', stranger: 'FF' },
  hilbert: { text: 'axiom L\nL -> +RF-LFL-FR+\nR -> -LF+RFR+FL-\nangle 90\ngeneration 4\n', segments: '255', member: '+RF-LFL-FR+', stranger: 'RL', dimension: 'log 4 / log 2 = 2' },
  fibonacci: { text: 'title Fibonacci\naxiom b\na -> ab\nb -> a\ngeneration 6\n', segments: null, member: 'abaab', stranger: 'abb', dimension: 'nothing is drawn' },
  parametric: { text: 'let r = 0.6\naxiom A(1)\nA(x) -> F(x)[+A(x*r)][-A(x*r)]\nangle 35\nstart 0 0 90\ngeneration 6\n', segments: '63', language: 'the axiom has parameters' },
  chance: { text: 'axiom F\nF -(1/2)-> F[+F]F\nF -(1/2)-> F[-F]F\nangle 25\nstart 0 0 90\ngeneration 4\n', segments: '81', language: 'has a probability' },
  space: { text: 'axiom A\nA -> F[&A]////[&A]////[&A]\nF -> F\nangle 30\ngeneration 4\n', segments: '40', member: 'A', stranger: 'AA', dimension: 'plane' },
  tables: { text: 'axiom a\ntable one\na -> aa\ntable two\na -> ab\nb -> b\nschedule one two\ngeneration 4\n', segments: null, member: 'aab', stranger: 'ba' },
  context: { text: 'axiom baaaa\nb < a -> b\nb -> a\na -> a\ngeneration 4\n', segments: null, member: 'abaaa', stranger: 'aa', dimension: 'nothing is drawn' },
};

async function tabsOfSystems() {
  for (const [name, system] of Object.entries(systems)) {
    if (isQuick && !['koch', 'fibonacci', 'context'].includes(name)) continue;
    const { text } = system;
    await page.getByRole('tab', { name: 'Figure', exact: true }).click();
    await type(text);
    const kind = sayJson(['show', '-'], text).class;
    includes(await page.locator('.about').innerText(), kind, `${name} has no mistake, and its class is said`);
    includes(await panel(), system.segments ? `${system.segments} segments` : 'draws nothing', `Figure of ${name}`);
    if (name === 'space' || name === 'plant' || name === 'parametric') await picture(`figure-${name}`);

    const words = await tab('Derivation');
    for (const n of [0, 1, 2]) includes(words, say(['derive', '-n', String(n), ...(name === 'chance' ? ['--seed', '1'] : []), '-'], text).trim(), `Derivation of ${name}, word ${n}`);

    const growth = await tab('Growth');
    if (/^(E?P?D0L)$/.test(kind)) includes(growth, sayJson(['growth', '-'], text).lengths.slice(0, 6).join(','), `Growth of ${name}`);
    else includes(growth, kind, `Growth of ${name} says why there is none`);

    await tab('Language');
    for (const [word, is] of [[system.member, true], [system.stranger, false]]) {
      if (!word) continue;
      await page.getByPlaceholder('abaab').fill(word);
      includes(await panel(), is ? `${word} is in the language.` : `${word} is not in the language.`, `Language of ${name}`);
    }
    await page.getByPlaceholder('abaab').fill('');
    if (!system.member) includes(await panel(), system.language, `Language of ${name} says why there is none`);

    await page.getByRole('tab', { name: 'Dimension', exact: true }).click();
    // Where measuring takes long the page says so; it ends when another system is typed.
    if (system.dimension === undefined) await sees(/Counting boxes|Measured/, `Dimension of ${name} says what it waits for`);
    else includes(await panel(), system.dimension, `Dimension of ${name}`);
  }
}

async function claims() {
  await tab('Claims');
  await sees('A | B is not 0L', 'the claim is checked');
  await page.locator('details').last().locator('summary').click();
  includes(await panel(), 'Suppose that a system generates it', 'the proof is folded out');
  await picture('claims');
  await type('claim  Wrong\nlet A = {a, aa}\nshow A is 0L\n');
  includes(await panel(), '✗ refuted', 'a wrong statement is refuted');
  await type('claim  Search\ntheorem for all 0L languages A, B: A | B is 0L\n');
  includes(await panel(), 'counterexample: A = {a}, B = {aa}', 'a counterexample is found by search');
  await picture('claims-search');
  const files = readdirSync(`${root}theory/finite`).filter((file) => file.endsWith('.claim')).slice(0, many);
  for (const file of files) {
    const path = `${root}theory/finite/${file}`;
    const [claim] = sayJson(['check', path]).claims;
    await page.getByRole('button', { name: 'Gallery' }).click();
    await page.getByLabel('kind').selectOption('claims');
    await page.getByRole('searchbox').fill(`finite/${file}`);
    await page.getByRole('button', { name: `theory/finite/${file}` }).click();
    const shown = await panel();
    includes(shown, claim.claim, `the claim ${file}`);
    for (const one of claim.statements) includes(shown, { proved: '✓ proved', refuted: '✗ refuted' }[one.verdict] + one.text, `a statement of ${file}`);
  }
  check(files.length === many, `${many} claims: ${files.length}`);
}

async function lessons() {
  await tab('Lessons');
  const answers = readdirSync(`${root}lessons/answers`).filter((file) => /-1\.\w+$/.test(file)).slice(0, many);
  for (const file of answers) {
    const number = String(Number(file.slice(0, 2)));
    await page.getByRole('combobox', { name: 'Lessons' }).selectOption(number);
    const lesson = sayJson(['lesson']).lessons.find((one) => String(one.lesson) === number);
    includes(await panel(), lesson.title, `lesson ${number} is there`);
    await type(readFileSync(`${root}lessons/answers/${file}`, 'utf8'));
    const mark = page.getByRole('button', { name: 'Mark my answer' }).first();
    await mark.click();
    includes(await panel(), '✓ right', `the answer to ${number}.1 is right`);
    await type(/claim$/.test(file) ? 'let A = {a}\nlet B = {b}\n' : /txt$/.test(file) ? 'zz\n' : 'axiom zz\n');
    await mark.click();
    const marked = await panel();
    check(/✗ wrong|\? undecided/.test(marked), `a wrong answer to ${number}.1 is not right`);
    if (number === '1') await picture('lessons');
  }
  check(answers.length === many, `${many} lessons: ${answers.length}`);
}

/** Copies the link, and returns what it holds of the look at the figure. */
async function linkedTo(what) {
  const old = await page.evaluate(() => location.hash);
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.waitForFunction((before) => location.hash !== before, old);
  const hash = await page.evaluate(() => location.hash);
  const bytes = Buffer.from(hash.slice(1).replaceAll('-', '+').replaceAll('_', '/'), 'base64');
  const { look } = JSON.parse(inflateRawSync(bytes).toString());
  check(look !== null && typeof look === 'object', `a link holds the look at ${what}`);
  return { ...look, hash };
}
/** How wide the part of Koch's curve is that two steps of zooming show: its width fills 92 % of the canvas before. */
const seenWidth = async () => {
  const { width, height } = await page.locator('.stage canvas').first().boundingBox();
  const [wide, high] = [81, 81 * Math.sqrt(3) / 6];
  return width / (Math.min((0.92 * width) / wide, (0.92 * height) / high) * 1.5 * 1.5);
};

/** What goes out of the page as a file: its name and its text. */
async function downloaded(work) {
  const [file] = await Promise.all([page.waitForEvent('download'), work()]);
  await settled();
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), 'latin1') };
}

/** What one does with a figure or a claim besides looking at it. */
async function doings() {
  await type(systems.koch.text);
  await tab('Figure');
  // Every format of a figure in the plane, by how such a file begins.
  const begins = { svg: '<?xml', pdf: '%PDF', png: '\x89PNG', tex: '%', html: '<!DOCTYPE html>', gif: 'GIF8', dxf: '', geojson: '{', csv: '' };
  for (const [format, begin] of Object.entries(begins)) {
    const file = await downloaded(() => page.getByLabel('Export').selectOption(format));
    check(file.name === `koch.${format}` || file.name.endsWith(`.${format}`), `the export of a figure is called ${file.name}`);
    check(file.text.length > 100 && file.text.startsWith(begin), `the export ${format} is such a file: ${JSON.stringify(file.text.slice(0, 20))}`);
  }
  const saved = await downloaded(() => page.getByRole('button', { name: 'Save', exact: true }).click());
  check(saved.name.endsWith('.lsys') && saved.text === systems.koch.text, 'Save gives the text of the editor');
  await page.setInputFiles('input[type=file]', { name: 'mine.lsys', mimeType: 'text/plain', buffer: Buffer.from(systems.plant.text) });
  await sees(/360 segments/, 'a file of one\'s own is opened');

  // Growth as a film ends where it began, and can be stopped.
  await page.getByRole('button', { name: /Play/ }).click();
  await page.getByRole('button', { name: /Pause/ }).waitFor();
  await sees(/n = 1 ·/, 'the film goes through the generations');
  await page.getByRole('button', { name: /Play/ }).waitFor();
  includes(await panel(), 'n = 4 · 360 segments', 'the film ends at the generation that was shown');

  // Sliders write into the text, where everybody sees it.
  await page.getByRole('slider', { name: 'angle' }).fill('30');
  await settled();
  check((await page.locator('.cm-content').innerText()).includes('angle 30'), 'the slider of the angle writes into the text');
  await type(systems.parametric.text);
  await page.getByRole('slider', { name: 'r', exact: true }).fill('0.5');
  await settled();
  check((await page.locator('.cm-content').innerText()).includes('let r = 0.5'), 'the slider of a constant writes into the text');

  // The editor is as wide as one likes, by the keyboard too.
  const before = (await page.locator('#left').boundingBox()).width;
  await page.getByRole('separator').focus();
  await page.keyboard.press('ArrowRight');
  check((await page.locator('#left').boundingBox()).width > before, 'the key → widens the editor');

  // A proof is saved as a certificate that verify accepts.
  await tab('Claims');
  await type('claim  Proved\nlet A = {a, aa}\nshow A is not 0L\n');
  includes(await panel(), '✓ proved', 'a statement is proved');
  const certificate = await downloaded(() => page.getByRole('button', { name: 'Save certificate' }).click());
  const checked = spawnSync(algae, ['verify', '-'], { input: certificate.text, encoding: 'utf8' });
  check(checked.status === 0, `verify accepts the certificate of the page: ${checked.stdout}${checked.stderr}`);

  // A search says how far it is, and is stopped by the button.
  await type('claim  Long\ntheorem for all 0L languages A, B: A B is EDT0L\n');
  await page.getByLabel('instances').fill('100000000');
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await sees('Stopped.', 'a search is stopped by the button');

  await tab('Figure');
  await type(systems.dragon.text);
  includes(await panel(), '128 segments', 'the figure is of what is written');
}

/** Exercises of somebody's own: they open, are marked, and the answer is handed in as a file that `algae mark` takes. */
async function pack() {
  const exercises = {
    'doubling.exercise': 'exercise Doubling\ntask Write a system with one rule whose lengths double.\nanswer system\nshow answer has 1 rule\nshow growth(answer) = 2^n\nhint Each letter has two successors.\n',
    'word.exercise': 'exercise A word\ntask Write the word of two letters a.\nanswer word\nshow answer == {aa}\n',
    'broken.exercise': 'exercise Broken\ntsk Write a.\n',
  };
  await tab('Figure');
  await page.setInputFiles('input[type=file]', Object.entries(exercises).map(([name, text]) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })));
  await sees('Exercises of your own', 'exercises of one\'s own open as a pack');
  const shown = await panel();
  includes(shown, 'Task doubling: Doubling', 'an exercise has its title');
  includes(shown, 'Write the word of two letters a.', 'another exercise has its task');
  includes(shown, 'line 2:', 'a mistake in an exercise is said with its line');
  const task = (name) => page.locator('.task').filter({ hasText: `Task ${name}` });
  await type('axiom a\na -> aaa\n');
  await task('doubling').getByRole('button', { name: 'Mark my answer' }).click();
  includes(await panel(), '✗ wrong', 'a wrong answer to an exercise of one\'s own');
  includes(await panel(), 'Each letter has two successors.', 'the hint of an exercise of one\'s own');
  await type('axiom a\na -> aa\n');
  await task('doubling').getByRole('button', { name: 'Mark my answer' }).click();
  includes(await panel(), '✓ right', 'a right answer to an exercise of one\'s own');
  await picture('lessons-pack');
  const answer = await downloaded(() => task('doubling').getByRole('button', { name: 'Hand in' }).click());
  check(answer.name === 'doubling.lsys', `an answer is handed in as a file: ${answer.name}`);
  const answers = mkdtempSync(`${tmpdir()}/algae-answers-`);
  writeFileSync(`${answers}/one.lsys`, answer.text);
  writeFileSync(`${folder}/doubling.exercise`, exercises['doubling.exercise']);
  const { answers: rows } = sayJson(['mark', `${folder}/doubling.exercise`, answers]);
  check(rows.length === 1 && rows[0].verdict === 'right' && rows[0].points === rows[0].of, `algae mark takes the file: ${JSON.stringify(rows)}`);
  rmSync(answers, { recursive: true });
  await type('');
  await task('word').getByRole('button', { name: 'Hand in' }).click();
  includes(await panel(), 'Write the answer on the left', 'an empty answer is not handed in');
  // The pack is in a link, and in the folder of the studio.
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.waitForFunction(() => location.hash.length > 20);
  const other = await context.newPage();
  await other.goto(page.url());
  await other.getByText('Task doubling').waitFor();
  check((await other.locator('.task').count()) === 3, 'a link brings the pack');
  await other.close();
  await page.getByRole('combobox', { name: 'Lessons' }).selectOption('1');
  await sees(/Task 1\.1/, 'a lesson comes after the pack');
  await page.getByRole('button', { name: 'Gallery' }).click();
  await page.getByLabel('kind').selectOption('folder');
  await page.getByRole('searchbox').fill('');
  await page.getByRole('button', { name: 'doubling.exercise' }).click();
  await sees('Task doubling', 'an exercise of the folder opens');
  check((await page.locator('.task').count()) === 1, 'the exercise of the folder is a pack of its own');
}

/** What another page shows of this one: a figure, and a claim with its verdict. */
async function embedded() {
  const shown = async (name, expected, title) => {
    await page.getByRole('button', { name: 'Embed', exact: true }).click();
    await page.getByLabel('Address of the page of static files').fill(address);
    await page.waitForFunction((start) => document.querySelector('textarea').value.includes(`src="${start}#`), address);
    const html = await page.getByLabel('HTML for another page').inputValue();
    check(html.includes(`title="${title}"`), `the frame of ${name} has a title: ${html.slice(-200)}`);
    await page.getByRole('button', { name: 'Close', exact: true }).click();
    const other = await context.newPage();
    await other.goto(/src="([^"]*)"/.exec(html)[1]);
    await other.getByText(expected).filter({ visible: true }).first().waitFor();
    await settled(other);
    for (const part of ['#left', '.tabs', '.bar']) check((await other.locator(part).filter({ visible: true }).count()) === 0, `${name} in another page is without ${part}`);
    await other.screenshot({ path: `${pictures}/embedded-${name}.png` });
    const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
    await other.evaluate(axe + ';0');
    const { violations } = await other.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
    check(violations.length === 0, `${name} in another page: ${violations.map((one) => `${one.id} (${one.nodes[0].html.slice(0, 160)})`).join('; ')}`);
    const [whole] = await Promise.all([context.waitForEvent('page'), other.getByRole('link', { name: 'algae studio' }).click()]);
    await whole.getByRole('button', { name: 'Gallery' }).waitFor();
    check(await whole.locator('.cm-content').isVisible(), `${name} in another page leads to the whole page`);
    await whole.close();
    await other.close();
  };
  await tab('Figure');
  await type(`title Koch & "co"\n${systems.koch.text}`);
  await shown('figure', /256 segments/, 'Figure: Koch &amp; &quot;co&quot;');
  await tab('Claims');
  await type('claim  Embedded\nlet A = {a, aa}\nshow A is not 0L\n');
  await shown('claim', '✓ proved', 'Claims: Embedded');
  await tab('Figure');
  await type(systems.koch.text);
}

/** The page in other languages: what one sees, and what a number does to a word. */
async function languages() {
  const said = {
    pt: { chooser: 'Língua da página', tabs: ['Figura', 'Linguagem', 'Lições'], counted: ['1 segmento', '4 segmentos', '256 segmentos'], member: 'F está na linguagem.' },
    cs: { chooser: 'Jazyk stránky', tabs: ['Obrázek', 'Jazyk', 'Lekce'], counted: ['1 úsečka', '4 úsečky', '256 úseček'], member: 'F patří do jazyka.' },
    ru: { chooser: 'Язык страницы', tabs: ['Рисунок', 'Язык', 'Уроки'], counted: ['1 отрезок', '4 отрезка', '256 отрезков'], member: 'F принадлежит языку.' },
  };
  await tab('Lessons');
  await page.getByRole('combobox', { name: 'Lessons' }).selectOption('10');
  await settled();
  await tab('Figure');
  let chooser = 'Language of the page';
  const choose = async (wanted) => {
    await Promise.all([page.waitForEvent('load'), page.getByLabel(chooser, { exact: true }).selectOption(wanted)]);
    chooser = said[wanted]?.chooser ?? 'Language of the page';
    await page.getByLabel(chooser, { exact: true }).waitFor();
    await settled();
  };
  for (const [wanted, texts] of Object.entries(said)) {
    await choose(wanted);
    check((await page.evaluate(() => document.documentElement.lang)) === wanted, `the page says that it speaks ${wanted}`);
    for (const [i, n] of [0, 1, 4].entries()) {
      await type(systems.koch.text.replace('generation 4', `generation ${n}`));
      includes(await tab(texts.tabs[0]), `n = ${n} · ${texts.counted[i]}`, `a number of segments in ${wanted}`);
    }
    await tab(texts.tabs[1]);
    await page.getByPlaceholder('abaab').fill('F');
    includes(await panel(), texts.member, `a word of the language in ${wanted}`);
    await picture(`language-${wanted}`);
    const title = sayJson(['lesson']).lessons.find((one) => one.lesson === 10).title;
    includes(await tab(texts.tabs[2]), title, `the lesson that was read is there in ${wanted}`);
    check((await page.getByRole('combobox', { name: texts.tabs[2] }).inputValue()) === '10', `the list of lessons stands at the one that is shown in ${wanted}`);
    await picture(`lessons-${wanted}`);
    await tab(texts.tabs[0]);
    await picture(`figure-${wanted}`);
    check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `the page in ${wanted} is as wide as the window`);
  }
  await choose('en');
  includes(await tab('Figure'), '256 segments', 'the page speaks English again, and shows what it showed');
}

/** The colours of the page may change while another tab is shown: a figure has those of now. */
async function inkedFor(theme, name) {
  const green = await page.evaluate((id) => {
    const canvas = document.querySelector(`#panel-${id} canvas`);
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const values = [];
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) values.push(data[i + 1]);
    return values.sort((a, b) => a - b);
  }, name.toLowerCase());
  const ink = theme === 'dark' ? green.at(-1) : green[0];
  check(green.length > 50 && (theme === 'dark' ? ink > 200 : ink < 90), `${name} has the ink of the ${theme} page: ${ink} of ${green.length} pixels`);
}

/** What people with other senses meet, as axe sees it. */
async function accessible() {
  const require = createRequire(import.meta.url);
  const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
  await page.evaluate(axe + ';0');
  const look = async (what) => {
    await settled();
    await frame();
    const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
    check(violations.length === 0, `${what}: ${violations.map((one) => `${one.id}, ${one.help} (${one.nodes[0].html.slice(0, 160)}: ${one.nodes[0].failureSummary})`).join('; ')}`);
  };
  for (const theme of isQuick ? ['light'] : ['light', 'dark']) {
    for (const one of ['Figure', 'Derivation', 'Growth', 'Language', 'Claims', 'Dimension', 'Lessons']) {
      await tab(one);
      await look(`${one}, ${theme}`);
      if (one === 'Figure' || one === 'Dimension') await inkedFor(theme, one);
      await picture(`${theme}-${one.toLowerCase()}`);
      await page.getByRole('button', { name: 'Present' }).click();
      await look(`${one}, ${theme}, presentation`);
      if (theme === 'light') await picture(`presented-${one.toLowerCase()}`);
      await page.keyboard.press('Escape');
      await page.locator('header').waitFor();
    }
    await page.getByRole('button', { name: 'Gallery' }).click();
    await look(`gallery, ${theme}`);
    await page.getByRole('button', { name: 'Close', exact: true }).click();
    await page.getByRole('button', { name: 'Embed', exact: true }).click();
    await look(`what another page needs, ${theme}`);
    await picture(`${theme}-embed`);
    await page.getByRole('button', { name: 'Close', exact: true }).click();
    await page.getByRole('button', { name: 'Dark', exact: true }).click();
  }
}

/** Prints how long a part took, which decides nothing. */
const part = async (name, work) => {
  const begun = performance.now();
  await work();
  console.log(`${name}: ${((performance.now() - begun) / 1000).toFixed(1)} s`);
};

try {
  await page.goto(address);
  await sees(/segments/, 'the first figure is drawn');
  await part('tabs of ten systems', tabsOfSystems);

  await tab('Figure');
  await type(systems.koch.text.replace('generation 4', 'generation 2'));
  await page.getByRole('button', { name: /Turtle/ }).click();
  await sees(/of 36/, 'the turtle stands in the word of generation 2');
  await page.getByLabel('step of the turtle').fill('14');
  await sees(/14 of 36: -, turn right by 60°/, 'the turtle says what its symbol does');
  await picture('turtle');
  await page.getByRole('button', { name: /Turtle/ }).click();

  await type(systems.plant.text);
  const box = await page.locator('.stage canvas').first().boundingBox();
  await page.mouse.move(box.x + box.width * 0.57, box.y + box.height * 0.62);
  for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -240);
  await picture('zoomed');
  await page.getByRole('button', { name: 'Whole figure' }).click();

  await type(systems.fibonacci.text);
  await tab('Derivation');
  await page.locator('.symbols').nth(5).locator('span').nth(3).click();
  await sees(/Ancestors: .*rule/, 'a letter shows its ancestors and its rule');
  await picture('derivation');
  await page.getByRole('button', { name: 'Tree' }).click();
  await picture('derivation-tree');
  await page.getByRole('button', { name: 'Tree' }).click();
  includes(await tab('Growth'), 'exponentially', 'growth says that it is exponential');
  check((await page.locator('.graph svg').count()) === 1, 'the graph of letters is drawn');
  await picture('growth');
  await tab('Language');
  await page.getByPlaceholder('abaab').fill('abaab');
  await picture('language');

  await tab('Figure');
  await type(systems.koch.text.replace('generation 4', 'generation 6'));
  includes(await panel(), '4 096 segments', 'koch has 4^6 segments');
  await tab('Dimension');
  await page.locator('#panel-dimension .dot').nth(2).focus();
  await sees(/boxes of side .* meet the figure/, 'a dot says how many boxes it stands for');
  await picture('dimension');

  await part('claims', claims);
  await part('lessons', lessons);

  await tab('Figure');
  await page.getByRole('button', { name: 'Gallery' }).click();
  await page.getByLabel('kind').selectOption('systems');
  await page.getByRole('searchbox').fill('plant');
  await page.locator('.card img').nth(3).waitFor();
  await picture('gallery');
  await page.locator('.card:has([data-name="plant-f"])').click();
  await settled();
  includes(await panel(), 'segments', 'a figure of the gallery is drawn');

  // A mistake is shown at its place.
  await type('axiom F\nF -> F+\nangel 60\n');
  await sees(/line 3: .*angle/, 'a mistake comes with its place and a suggestion');
  await picture('mistake');
  await type(systems.plant.text);

  // A link holds all of it.
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.waitForFunction(() => location.hash.length > 20);
  const second = await context.newPage();
  await second.goto(page.url());
  await settled(second);
  check((await second.locator('.cm-content').innerText()).includes('F-[[X]+X]'), 'a link brings the system back');
  await second.close();

  // So does the place one looks at, and the turtle's step.
  await type(systems.koch.text);
  await page.getByRole('button', { name: 'zoom in' }).click();
  await page.getByRole('button', { name: 'zoom in' }).click();
  const looked = await linkedTo('the zoomed figure');
  check(Math.abs(looked.view[2] / (await seenWidth()) - 1) < 0.01, 'a link holds how near the figure is');
  await page.getByRole('button', { name: /Turtle/ }).click();
  await sees(/of 596/, 'the turtle stands in the word of generation 4');
  await page.getByLabel('step of the turtle').fill('14');
  const third = await context.newPage();
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.waitForFunction((old) => location.hash !== old, looked.hash);
  await third.goto(page.url());
  await third.getByText(/14 of 596/).waitFor();
  await settled(third);
  check((await third.getByLabel('step of the turtle').inputValue()) === '14', 'a link brings the turtle back to its step');
  await third.close();
  await page.getByRole('button', { name: /Turtle/ }).click();

  await part('doings', doings);
  await part('exercises of one\'s own', pack);
  await part('embedded', embedded);
  if (!isQuick) await part('languages', languages);

  await page.getByRole('button', { name: 'Present' }).click();
  await page.keyboard.press('ArrowLeft');
  await sees(/n = 3/, 'the key ← goes a generation back in the presentation');
  await page.keyboard.press('Escape');
  await page.keyboard.press('ArrowRight');
  await type(systems.koch.text);

  await part('axe', accessible);
  check(foreign.length === 0, `nothing is loaded from elsewhere: ${foreign.slice(0, 3).join(', ')}`);
  check(said.length === 0, `the page reports no errors: ${said.slice(0, 5).join(' | ')}`);
} catch (error) {
  check(false, String(error?.stack ?? error));
  await page.screenshot({ path: `${pictures}/failure.png` }).catch(() => undefined);
} finally {
  await browser.close();
  studio.kill('SIGINT');
}
const status = await new Promise((done) => (studio.exitCode === null ? studio.on('exit', (code) => done(code)) : done(studio.exitCode)));
check(status === 0, `Ctrl-C ends the studio with 0, not ${status}`);
rmSync(folder, { recursive: true });
end();
