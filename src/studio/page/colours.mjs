// Whether the colours of the page can be told apart, and read, by eyes that see fewer colours.
//
//     node colours.mjs
//
// What the page says by a colour it says by a sign or a shape too; this looks whether the colours help those who do not see all of them. Those
// that stand beside each other for different things, of a verdict, of the turtle, of a derivation, are compared as people with
// protanopia, deuteranopia and tritanopia see them: by the matrices of Machado, Oliveira and Fernandes (2009) for the whole lack of a kind
// of cone, and by the distance in CIELAB. Letters are compared with what they stand on by the contrast of WCAG 2.
import { readFileSync } from 'node:fs';
import { checks } from './driving.mjs';

const { check, end } = checks();

/** For each kind of eye, what it makes of red, green and blue light. */
const eyes = {
  'all cones': [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};

const clamp = (value) => Math.min(1, Math.max(0, value));
/** Amounts of light of a colour #rrggbb. */
const light = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255).map((one) => (one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4));
const seen = (rgb, matrix) => matrix.map((row) => clamp(row.reduce((sum, part, i) => sum + part * rgb[i], 0)));
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};
/** CIELAB under daylight (D65). */
function lab([r, g, b]) {
  const f = (t) => (t > 216 / 24389 ? Math.cbrt(t) : (t * 24389) / 27 / 116 + 16 / 116);
  const x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
  const y = f(luminance([r, g, b]));
  const z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const distance = (a, b) => Math.hypot(...lab(a).map((one, i) => one - lab(b)[i]));

// The measure is right about what is known: white and black, and red and green of the same lightness for an eye without one kind of cone.
const [white, black] = [light('#ffffff'), light('#000000')];
check(Math.abs(contrast(white, black) - 21) < 1e-9, 'white on black has the contrast 21');
check(Math.abs(distance(white, black) - 100) < 0.1, 'white is a hundred from black');
const [red, green] = [light('#b35900'), light('#5c8000')];
check(distance(red, green) > 40, 'a brown and an olive are far from each other');
check(distance(seen(red, eyes.deuteranopia), seen(green, eyes.deuteranopia)) < 15, 'for an eye without the cones of green they are near');

/** The colours of style.css, by theme and name. */
const style = readFileSync(new URL('src/style.css', import.meta.url), 'utf8');
const themes = {};
for (const [, dark, body] of style.matchAll(/:root(\[data-theme="dark"\])?\s*\{([^}]*)\}/g)) themes[dark ? 'dark' : 'light'] = Object.fromEntries([...body.matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})\b/g)].map(([, name, value]) => [name, value]));

/** Colours that stand beside each other for different things. */
const groups = [
  ['good', 'bad', 'open'], // verdicts
  ['stroke', 'focus', 'accent'], // what the turtle has drawn, draws now, and the turtle itself
  ['accent', 'focus'], // dots and the line of a plot
  ['mark', 'paper', 'accent'], // ancestors, other letters, the chosen letter
];
const apart = 20; // in CIELAB, of which 2.3 can just be seen side by side
/** Letters on what they stand on, and how much contrast they need: lines and large shapes less than letters. */
const read = [
  ...['ink', 'quiet', 'accent', 'bad', 'good', 'open', 'focus'].flatMap((one) => [[one, 'paper', 4.5], [one, 'panel', 4.5]]),
  ['accent-ink', 'accent', 4.5],
  ['ink', 'mark', 4.5],
  ['stroke', 'paper', 3],
];

let compared = 0;
for (const [theme, colours] of Object.entries(themes))
  for (const [eye, matrix] of Object.entries(eyes)) {
    const as = (name) => seen(light(colours[name]), matrix);
    for (const group of groups)
      group.forEach((one, i) =>
        group.slice(i + 1).forEach((other) => {
          ++compared;
          const far = distance(as(one), as(other));
          check(far >= apart, `${theme}, ${eye}: ${one} and ${other} are ${far.toFixed(1)} apart, expected at least ${apart}`);
        }),
      );
    for (const [letter, ground, least] of read) {
      ++compared;
      const found = contrast(as(letter), as(ground));
      check(found >= least, `${theme}, ${eye}: ${letter} on ${ground} has the contrast ${found.toFixed(2)}, expected at least ${least}`);
    }
  }
const expected = 2 * 4 * (3 + 3 + 1 + 3 + 17);
check(compared === expected, `${expected} pairs of colours were compared, not ${compared}`);
end();
