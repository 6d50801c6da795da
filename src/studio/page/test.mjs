// Drives the page in Chromium as a person would, and reads what is on the screen.
//
//     node test.mjs ALGAE PICTURES [CHROMIUM]
//
// starts the studio of the command ALGAE, opens every tab, and writes a picture of each into the folder PICTURES. It exits with 1 if something
// that should be there is not. Times are measured and printed, and decide nothing.
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { chromium } from 'playwright-core';

const [algae, pictures, executable = '/usr/bin/chromium'] = process.argv.slice(2);
mkdirSync(pictures, { recursive: true });

let passed = 0;
const failures = [];
const check = (condition, what) => {
  if (condition) ++passed;
  else {
    failures.push(what);
    console.error(`FAILED: ${what}`);
  }
};

const studio = spawn(algae, ['studio'], { stdio: ['ignore', 'pipe', 'inherit'] });
const address = await new Promise((done, fail) => {
  let text = '';
  studio.stdout.on('data', (piece) => {
    text += piece;
    if (text.includes('\n')) done(text.split('\n')[0]);
  });
  studio.on('exit', () => fail(new Error('the studio ended')));
});

const browser = await chromium.launch({ executablePath: executable, args: ['--no-sandbox', '--use-gl=swiftshader', '--enable-unsafe-swiftshader'] });
const context = await browser.newContext({ viewport: { width: 1400, height: 860 }, colorScheme: 'light' });
const page = await context.newPage();
const said = [];
page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
page.on('pageerror', (error) => said.push(String(error)));
const foreign = [];
page.on('request', (request) => {
  if (!request.url().startsWith(address) && !request.url().startsWith('data:') && !request.url().startsWith('blob:')) foreign.push(request.url());
});

const picture = (name) => page.screenshot({ path: `${pictures}/${name}.png` });
const tab = (name) => page.getByRole('tab', { name, exact: true }).click();
const sees = async (text, what, timeout = 15000) => {
  try {
    await page.getByText(text).filter({ visible: true }).first().waitFor({ timeout });
    check(true, what);
  } catch {
    check(false, what);
  }
};
/** Puts a text into the editor, as one types it. */
const type = async (text) => {
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
};

const systems = {
  koch: 'axiom F\nF -> F+F--F+F\nangle 60\ngeneration 6\n',
  plant: 'axiom X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\nangle 22.5\nstart 0 0 90\ngeneration 5\n',
  dragon: 'axiom FX\nX -> X+YF+\nY -> -FX-Y\nangle 90\ngeneration 10\n',
  hilbert: 'axiom L\nL -> +RF-LFL-FR+\nR -> -LF+RFR+FL-\nangle 90\ngeneration 5\n',
  fibonacci: 'title Fibonacci\naxiom b\na -> ab\nb -> a\ngeneration 6\n',
  parametric: 'let r = 0.6\naxiom A(1)\nA(x) -> F(x)[+A(x*r)][-A(x*r)]\nangle 35\nstart 0 0 90\ngeneration 6\n',
  chance: 'axiom F\nF -(1/2)-> F[+F]F\nF -(1/2)-> F[-F]F\nangle 25\nstart 0 0 90\ngeneration 4\n',
  space: 'axiom A\nA -> F[&A]////[&A]////[&A]\nF -> F\nangle 30\nstart 0 0 90\ngeneration 4\n',
  tables: 'axiom a\ntable one\na -> aa\ntable two\na -> ab\nb -> b\nschedule one two\ngeneration 4\n',
  context: 'axiom baaaa\nb < a -> b\nb -> a\na -> a\ngeneration 4\n',
};

try {
  await page.goto(address);
  await sees(/segments/, 'the first figure is drawn');
  await picture('figure');

  const problems = {};
  for (const [name, text] of Object.entries(systems)) {
    await type(text);
    await page.waitForTimeout(700);
    problems[name] = await page.locator('.about').innerText();
    check(!(await page.locator('.about.bad').count()), `${name} has no mistake: ${problems[name]}`);
    for (const one of ['Figure', 'Derivation', 'Growth', 'Language']) {
      await tab(one);
      const panel = page.getByRole('tabpanel').filter({ visible: true, hasText: /\S/ });
      check(await panel.waitFor({ timeout: 20000 }).then(() => true, () => false), `${one} of ${name} shows something`);
    }
    await tab('Figure');
    await page.waitForTimeout(400);
    if (name === 'space' || name === 'plant' || name === 'parametric') await picture(`figure-${name}`);
  }

  await type(systems.koch);
  await sees('4 096 segments'.replace(' ', '\u202f'), 'koch has 4^6 segments');
  // Time from a keystroke to the picture, for the system that is in the editor.
  const times = {};
  for (const name of ['koch', 'plant', 'hilbert', 'space']) {
    await type(systems[name]);
    await page.waitForTimeout(800);
    const all = [];
    for (let i = 0; i < 20; ++i) {
      const begun = await page.evaluate(() => performance.now());
      await page.keyboard.type(i % 2 ? '\n' : ' ');
      await page.waitForFunction((before) => window.algaeFigurePainted() > before, begun, { timeout: 10000 });
      all.push((await page.evaluate(() => window.algaeFigurePainted())) - begun);
    }
    all.sort((a, b) => a - b);
    times[name] = Math.round(all[10]);
  }
  console.log(`keystroke to picture, median of 20, in milliseconds: ${JSON.stringify(times)}`);

  await type(systems.koch.replace('generation 6', 'generation 2'));
  await page.waitForTimeout(500);
  await page.getByRole('button', { name: /Turtle/ }).click();
  await sees(/of 36/, 'the turtle stands in the word of generation 2');
  await page.getByLabel('step of the turtle').fill('14');
  await page.waitForTimeout(200);
  await picture('turtle');
  await page.getByRole('button', { name: /Turtle/ }).click();

  await type(systems.plant);
  await page.waitForTimeout(700);
  const box = await page.locator('.stage canvas').first().boundingBox();
  await page.mouse.move(box.x + box.width * 0.57, box.y + box.height * 0.62);
  for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -240);
  await page.waitForTimeout(1200);
  await picture('zoomed');
  await page.keyboard.press('Tab');

  await type(systems.fibonacci);
  await tab('Derivation');
  await sees('abaab', 'the word of generation 4 is there');
  await page.locator('.symbols').nth(5).locator('span').nth(3).click();
  await sees(/Ancestors: .*rule/, 'a letter shows its ancestors and its rule');
  await picture('derivation');
  await page.getByRole('button', { name: 'Tree' }).click();
  await page.waitForTimeout(300);
  await picture('derivation-tree');
  await page.getByRole('button', { name: 'Tree' }).click();

  await tab('Growth');
  await sees('exponentially', 'growth says that it is exponential');
  check((await page.locator('.graph svg').count()) === 1 || (await page.waitForSelector('.graph svg', { timeout: 10000 }).then(() => true, () => false)), 'the graph of letters is drawn');
  await page.waitForTimeout(1500);
  await picture('growth');

  await tab('Language');
  await page.getByPlaceholder('abaab').fill('abaab');
  await sees('abaab is in the language.', 'abaab is in the language of Fibonacci');
  await page.getByPlaceholder('abaab').fill('abb');
  await sees('abb is not in the language.', 'abb is not');
  await page.getByPlaceholder('abaab').fill('abaab');
  await page.waitForTimeout(300);
  await picture('language');

  await tab('Claims');
  await sees('A | B is not 0L', 'the claim is checked', 20000);
  await sees('✓ proved', 'its statements are proved');
  await page.locator('details').last().click();
  await sees('Suppose that a system generates it', 'the proof is folded out');
  await picture('claims');
  await type('claim  Wrong\nlet A = {a, aa}\nshow A is 0L\n');
  await sees('✗ refuted', 'a wrong statement is refuted');
  await type('claim  Search\ntheorem for all 0L languages A, B: A | B is 0L\n');
  await sees('counterexample', 'a counterexample is found by search', 20000);
  await picture('claims-search');

  await tab('Figure');
  await type(systems.koch);
  await tab('Dimension');
  await sees(/log 4 \/ log 3/, 'the dimension is log 4 / log 3', 30000);
  await page.locator('#panel-dimension .dot').nth(3).hover();
  await page.waitForTimeout(300);
  await picture('dimension');

  await tab('Lessons');
  await sees('Words and morphisms', 'the first lesson is there');
  await type('abaa\n');
  await page.getByRole('button', { name: 'Mark my answer' }).first().click();
  await sees(/✗ wrong|✓ right/, 'an answer is marked');
  await picture('lessons');

  await tab('Figure');
  await page.getByRole('button', { name: 'Gallery' }).click();
  await page.waitForTimeout(2500);
  await page.getByRole('searchbox').fill('plant');
  await page.waitForTimeout(2500);
  await picture('gallery');
  check((await page.locator('.card img').count()) > 3, 'the gallery shows pictures');
  await page.locator('.card').first().click();
  await page.waitForTimeout(1200);
  await sees(/segments/, 'a figure of the gallery is drawn');

  // A mistake is shown at its place.
  await type('axiom F\nF -> F+\nangel 60\n');
  await sees(/angle/, 'a mistake comes with a suggestion');
  await page.waitForTimeout(400);
  await picture('mistake');
  await type(systems.plant);
  await page.waitForTimeout(600);

  // A link holds all of it.
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.waitForFunction(() => location.hash.length > 20);
  const link = page.url();
  const second = await context.newPage();
  await second.goto(link);
  await second.getByText('F-[[X]+X]').first().waitFor({ timeout: 10000 }).then(() => check(true, 'a link'), () => check(false, 'a link brings the system back'));
  await second.close();

  await page.getByRole('button', { name: 'Dark' }).click();
  await page.waitForTimeout(300);
  await picture('dark');
  await page.getByRole('button', { name: 'Present' }).click();
  await page.waitForTimeout(800);
  await page.keyboard.press('ArrowLeft');
  await page.waitForTimeout(600);
  await sees(/n = 4/, 'the key ← goes a generation back in the presentation');
  await picture('presentation');
  await page.keyboard.press('Escape');
  await page.waitForTimeout(300);

  // What people with other senses meet, as axe sees it.
  const require = createRequire(import.meta.url);
  const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
  for (const theme of ['dark', 'light']) {
    for (const one of ['Figure', 'Derivation', 'Growth', 'Language', 'Claims', 'Dimension', 'Lessons']) {
      await tab(one);
      await page.waitForTimeout(700);
      await page.evaluate(axe + ';0');
      const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
      const serious = violations.filter((violation) => violation.impact === 'serious' || violation.impact === 'critical');
      check(serious.length === 0, `${one}, ${theme}: ${serious.map((violation) => `${violation.help} (${violation.nodes[0].html.slice(0, 120)})`).join('; ')}`);
    }
    await page.getByRole('button', { name: 'Dark' }).click();
  }

  check(foreign.length === 0, `nothing is loaded from elsewhere: ${foreign.slice(0, 3).join(', ')}`);
  check(said.length === 0, `the page reports no errors: ${said.slice(0, 5).join(' | ')}`);
} catch (error) {
  check(false, String(error));
  await picture('failure');
} finally {
  await browser.close();
  studio.kill('SIGINT');
}
const status = await new Promise((done) => (studio.exitCode === null ? studio.on('exit', (code) => done(code)) : done(studio.exitCode)));
check(status === 0, `Ctrl-C ends the studio with 0, not ${status}`);
console.log(`${passed} passed, ${failures.length} failed`);
process.exit(failures.length > 0 ? 1 : 0);
