// Prints the time from a keystroke to the picture, for four systems of the gallery: the median of 50, from the event of the key to the
// first message after the frame that shows the figure.
//
//     node times.mjs ALGAE PICTURES [CHROMIUM]
//
// It decides nothing: times are for people who make the page faster.
import { chromium } from 'playwright-core';
import { startedStudio } from './driving.mjs';

const [algae, , executable = '/usr/bin/chromium'] = process.argv.slice(2);
const { studio, address } = await startedStudio(algae);
const browser = await chromium.launch({ executablePath: executable, args: ['--no-sandbox', '--use-gl=swiftshader', '--enable-unsafe-swiftshader'] });
const page = await browser.newPage({ viewport: { width: 1400, height: 860 } });
await page.addInitScript(() => addEventListener('keydown', (event) => (window.keyAt = event.timeStamp), true));
await page.goto(address);
const settled = () => page.waitForFunction(() => !document.querySelector('[aria-busy="true"]'));
const median = (all) => Math.round(all.sort((a, b) => a - b)[Math.floor(all.length / 2)]);
console.log('system          n   key to picture   question to answer   (medians of 50, milliseconds)');
try {
  for (const [name, n] of [['koch', 6], ['plant-f', 5], ['honda-a', 10], ['hilbert-3d', 4]]) {
    await page.getByRole('button', { name: 'Gallery' }).click();
    await page.getByRole('searchbox').fill(name);
    await page.locator(`.card:has([data-name="${name}"])`).click();
    await settled();
    await page.getByRole('spinbutton', { name: 'generation' }).fill(String(n));
    await page.keyboard.press('Tab');
    await settled();
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+End');
    const pictures = [];
    const answers = [];
    for (let i = 0; i < 50; ++i) {
      await page.evaluate(() => performance.clearResourceTimings());
      const before = await page.evaluate(() => performance.now());
      await page.keyboard.type(i % 2 ? ' ' : '\n');
      await page.waitForFunction((from) => window.algaeFigurePainted() > from, before);
      const [picture, answer] = await page.evaluate(() => {
        const asked = performance.getEntriesByType('resource').filter((one) => one.name.endsWith('/ask'));
        return [window.algaeFigurePainted() - window.keyAt, Math.max(...asked.map((one) => one.duration))];
      });
      pictures.push(picture);
      answers.push(answer);
      await settled();
    }
    console.log(`${name.padEnd(14)} ${String(n).padStart(2)} ${String(median(pictures)).padStart(16)} ${String(median(answers)).padStart(20)}`);
  }
} finally {
  await browser.close();
  studio.kill('SIGINT');
}
