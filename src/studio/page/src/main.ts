// The page: an editor on the left, what follows from its text on the right.

import { askJson, Latest, Refusal } from './ask';
import { ClaimsTab } from './claims';
import { DerivationTab } from './derivation';
import { DimensionTab } from './dimension';
import { download, el, later, speak } from './dom';
import { Editor } from './editor';
import { engine, isStatic } from './engine';
import { FigureTab } from './figure';
import { Gallery } from './gallery';
import { GrowthTab } from './growth';
import { LanguageTab } from './language';
import { LessonsTab } from './lessons';
import { change, describe, described, fromLink, listen, state, systemQuestion, tabs, toLink, type Description, type Kind, type PackedExercise, type State, type Tab } from './state';
import { choose, language, languages, texts } from './texts';

let documentShown: Kind = 'system';

const about = el('div', { class: 'about', id: 'about', role: 'status' });
const editorPlace = el('div', { class: 'editor' });
const editor = new Editor(
  editorPlace,
  (kind, text) => change({ [kind]: text } as Partial<State>),
  (count, first) => {
    trouble = count > 0 ? first : '';
    showAbout();
  },
);
let summary = ''; // of the system
let trouble = ''; // with the document that is shown, or with the last thing that was tried

/** The line under the editor. */
function showAbout(): void {
  about.textContent = trouble || (documentShown === 'system' ? summary : '');
  about.classList.toggle('bad', trouble !== '');
}

function complain(error: unknown): void {
  trouble = error instanceof Error ? error.message : String(error);
  showAbout();
}

const panels = {
  figure: new FigureTab(editor),
  derivation: new DerivationTab(editor),
  growth: new GrowthTab(),
  language: new LanguageTab(),
  claims: new ClaimsTab(editor),
  dimension: new DimensionTab(),
  lessons: new LessonsTab(),
};
const tabButtons = Object.fromEntries(
  tabs.map((tab) => [tab, el('button', { role: 'tab', id: `tab-${tab}`, 'aria-controls': `panel-${tab}`, onclick: () => change({ tab }) }, texts.tabs[tab])]),
) as Record<Tab, HTMLButtonElement>;
/** The question that a tab is for: where the engine does not answer it, the tab is grey and says why. */
const tabQuestions: Partial<Record<Tab, string>> = { dimension: 'dimension', claims: 'check', language: 'member', lessons: 'lesson' };
for (const tab of tabs) {
  const lack = engine.lacks(tabQuestions[tab] ?? '');
  if (!lack) continue;
  tabButtons[tab].classList.add('lacks');
  tabButtons[tab].title = lack;
}
const kinds: Kind[] = ['system', 'claim', 'answer'];
const kindButtons = Object.fromEntries(kinds.map((kind) => [kind, el('button', { role: 'tab', onclick: () => showDocument(kind) }, texts.documents[kind])])) as Record<Kind, HTMLButtonElement>;

function showDocument(kind: Kind): void {
  documentShown = kind;
  trouble = '';
  editor.show(kind, state[kind]);
  showAbout();
  for (const one of kinds) {
    kindButtons[one].setAttribute('aria-selected', String(one === kind));
    kindButtons[one].tabIndex = one === kind ? 0 : -1;
  }
}

/** Ends when the panel shows what it is for. */
function showTab(): Promise<void> | void {
  for (const tab of tabs) {
    const isShown = tab === state.tab;
    tabButtons[tab].setAttribute('aria-selected', String(isShown));
    tabButtons[tab].tabIndex = isShown ? 0 : -1;
    panels[tab].root.hidden = !isShown;
    panels[tab].root.setAttribute('aria-labelledby', `tab-${tab}`);
    panels[tab].visible = isShown;
  }
  const wanted: Kind = state.tab === 'claims' ? 'claim' : state.tab === 'lessons' ? 'answer' : 'system';
  if (wanted !== documentShown) showDocument(wanted);
  if (state.tab !== 'derivation') editor.point(null);
  return panels[state.tab].update();
}

/** Arrow keys within a list of tabs. */
function tabKeys<T extends string>(names: readonly T[], buttons: Record<T, HTMLButtonElement>): (event: KeyboardEvent) => void {
  return (event) => {
    const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (by === 0) return;
    const at = names.findIndex((name) => buttons[name] === document.activeElement);
    if (at < 0) return;
    const next = buttons[names[(at + by + names.length) % names.length]!]!;
    next.focus();
    next.click();
    event.preventDefault();
  };
}

// What is known of the system, again whenever it changes.

const describing = new Latest();
let describedText = '';

async function lookAtSystem(): Promise<void> {
  if (describedText === state.system) return;
  const text = state.system;
  try {
    const found = await describing.run((signal) => askJson<Description>(systemQuestion('describe'), { signal }));
    if (!found) return;
    describedText = text;
    summary = [found.title, found.class].filter(Boolean).join(' · ');
    showAbout();
    document.title = found.title ? `${found.title} · ${texts.title}` : texts.title;
    describe(found);
  } catch (error) {
    // The editor says what is wrong with the text; the panel keeps what it showed last.
    if (!(error instanceof Refusal)) complain(error);
  }
}

listen((changed) => {
  if (changed.has('system')) {
    panels.growth.forget();
    panels.dimension.forget();
    void lookAtSystem();
  }
  if (changed.has('tab')) void showTab();
  if (changed.has('system') && documentShown === 'system' && !editor.holds(state.system)) editor.show('system', state.system);
  if (changed.has('claim') && documentShown === 'claim' && !editor.holds(state.claim)) editor.show('claim', state.claim);
  if (changed.has('embed')) document.body.classList.toggle('embed', state.embed);
  void panels[state.tab].update();
});

// The head of the page

function openPack(pack: PackedExercise[]): void {
  change({ pack, lesson: 0, tab: 'lessons' });
}

async function open(from: 'gallery' | 'theory' | 'folder', name: string): Promise<void> {
  try {
    const { text } = await askJson<{ text: string }>({ question: 'open', from, file: name });
    if (name.endsWith('.exercise')) return openPack([{ file: name, text }]);
    const isClaim = from === 'theory' || name.endsWith('.claim');
    const file = name.split('/').pop()!.replace(/^([^.]+)$/, '$1.lsys');
    change(isClaim ? { claim: text, tab: 'claims', file } : { system: text, n: null, seed: null, file, tab: state.tab === 'claims' || state.tab === 'lessons' ? 'figure' : state.tab });
    showDocument(isClaim ? 'claim' : 'system');
  } catch (error) {
    complain(error);
  }
}

const gallery = new Gallery((from, name) => void open(from, name));

const picker = el('input', { type: 'file', accept: '.lsys,.claim,.txt,.exercise', multiple: true, hidden: true });
picker.addEventListener('change', () => void openFiles([...(picker.files ?? [])]));

/** Exercises are a pack, however many they are; of other files the first one is opened. */
async function openFiles(files: File[]): Promise<void> {
  picker.value = ''; // so that the same file can be chosen again
  const exercises = files.filter((file) => file.name.endsWith('.exercise')).sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
  if (exercises.length > 0) return openPack(await Promise.all(exercises.map(async (file) => ({ file: file.name, text: await file.text() }))));
  const file = files[0];
  if (!file) return;
  const text = await file.text();
  const isClaim = file.name.endsWith('.claim');
  change(isClaim ? { claim: text, tab: 'claims', file: file.name } : { system: text, n: null, seed: null, file: file.name });
  showDocument(isClaim ? 'claim' : 'system');
}

function save(): void {
  const text = state[documentShown];
  const end = documentShown === 'claim' || (documentShown === 'answer' && /^\s*(let|show)\b/m.test(text)) ? '.claim' : '.lsys';
  download(text, (state.file.replace(/\.\w+$/, '') || 'system') + end, 'text/plain');
}

/** Puts all of the page into its address, which is returned. */
async function putIntoAddress(): Promise<string> {
  const link = `${location.origin}${location.pathname}#${await toLink(panels.figure.look())}`;
  history.replaceState(null, '', link);
  return link;
}

async function copyLink(): Promise<void> {
  const link = await putIntoAddress();
  try {
    await navigator.clipboard.writeText(link);
    speak(texts.copied);
    copyButton.textContent = `✓ ${texts.copied}`;
  } catch {
    copyButton.textContent = texts.linkInAddress;
  }
  setTimeout(() => (copyButton.textContent = texts.copyLink), 1800);
}
const copyButton = el('button', { onclick: () => void copyLink() }, texts.copyLink);

// A part of the page for a page of somebody else's.

const embedAddress = el('input', { type: 'url', class: 'address', 'aria-label': texts.embedAddress });
const embedText = el('textarea', { readonly: true, rows: 6, 'aria-label': texts.embedText, spellcheck: 'false' });
const embedCopy = el('button', { class: 'main', onclick: () => void copyEmbed() }, texts.copy);
const embedDialog = el(
  'dialog',
  { class: 'small', 'aria-label': texts.embed },
  el(
    'div',
    { class: 'inside' },
    el('div', { class: 'bar' }, el('b', {}, texts.embed), el('span', { class: 'gap' }), embedCopy, el('button', { onclick: () => embedDialog.close() }, texts.close)),
    el('div', { class: 'panel' }, el('p', {}, texts.embedHelp), el('p', {}, el('label', {}, texts.embedAddress, embedAddress)), embedText, el('p', { class: 'note' }, isStatic ? '' : texts.embedServer)),
  ),
);
embedAddress.addEventListener('input', () => void writeEmbed());

/** The HTML that shows what the tab shows: a figure, or a claim with its verdict. */
async function writeEmbed(): Promise<void> {
  const link = `${embedAddress.value}#${await toLink(panels.figure.look(), { embed: true })}`;
  const quoted = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
  const title = `${texts.tabs[state.tab]}: ${(state.tab === 'claims' ? /^\s*(?:claim|theorem)\s+(.*)$/m.exec(state.claim)?.[1] : described()?.title) || state.file}`;
  embedText.value = `<iframe src="${quoted(link)}" title="${quoted(title)}" width="640" height="480" loading="lazy" style="border: 0"></iframe>`;
}

async function embed(): Promise<void> {
  embedAddress.value = isStatic ? location.origin + location.pathname : 'https://example.org/studio/';
  await writeEmbed();
  embedDialog.showModal();
  embedText.select();
}

async function copyEmbed(): Promise<void> {
  try {
    await navigator.clipboard.writeText(embedText.value);
    speak(texts.copied);
    embedCopy.textContent = `✓ ${texts.copied}`;
  } catch {
    embedText.select();
  }
  setTimeout(() => (embedCopy.textContent = texts.copy), 1800);
}

/** Out of a page of somebody else's into a page of its own, with all that is shown. */
const wholePage = el('a', { id: 'whole', target: '_blank', rel: 'noopener', href: '#' }, texts.title);
async function linkToWhole(): Promise<void> {
  wholePage.href = `${location.origin}${location.pathname}#${await toLink(panels.figure.look(), { embed: false })}`;
}
wholePage.addEventListener('pointerenter', () => void linkToWhole());
wholePage.addEventListener('focus', () => void linkToWhole());

const languageChooser = el('select', { 'aria-label': texts.languageHelp, title: texts.languageHelp }, ...Object.entries(languages).map(([name, { language: said }]) => el('option', { value: name, lang: name, selected: name === language }, said)));
languageChooser.addEventListener('change', () => {
  // Every text of the page is another one, so it is loaded anew, with what it shows in its address.
  if (choose(languageChooser.value)) void putIntoAddress().then(() => location.reload());
});

function setTheme(theme: string): void {
  document.documentElement.dataset['theme'] = theme;
  themeButton.setAttribute('aria-pressed', String(theme === 'dark'));
  panels.figure.repaint();
  panels.dimension.repaint();
}
const themeButton = el('button', { 'aria-pressed': 'false', onclick: () => setTheme(document.documentElement.dataset['theme'] === 'dark' ? 'light' : 'dark') }, texts.dark);

let size = 16;
function setSize(pixels: number): void {
  size = Math.min(40, Math.max(11, pixels));
  document.documentElement.style.setProperty('--size', `${size}px`);
  editor.view.requestMeasure();
}

function present(on: boolean): void {
  document.body.classList.toggle('present', on);
  panels.figure.repaint();
  if (on) {
    void document.documentElement.requestFullscreen?.().catch(() => undefined);
    panels[state.tab].root.querySelector<HTMLElement>('canvas, [tabindex="0"]')?.focus();
  } else if (document.fullscreenElement) void document.exitFullscreen();
}

const divider = el('div', { id: 'divider', role: 'separator', 'aria-orientation': 'vertical', 'aria-label': texts.widthOfEditor, 'aria-valuemin': 0, 'aria-valuemax': 100, 'aria-valuenow': 36, tabindex: '0' });
const left = el(
  'section',
  { id: 'left', 'aria-label': texts.editor },
  el('div', { class: 'tabs', role: 'tablist', 'aria-label': texts.documentKinds, onkeydown: tabKeys(kinds, kindButtons) }, ...kinds.map((kind) => kindButtons[kind])),
  editorPlace,
  about,
);
function widen(pixels: number): void {
  const wide = Math.max(180, Math.min(innerWidth - 260, pixels));
  left.style.width = `${wide}px`;
  divider.setAttribute('aria-valuenow', String(Math.round((100 * wide) / innerWidth)));
}
divider.addEventListener('pointerdown', (event) => {
  divider.setPointerCapture(event.pointerId);
  const move = (moved: PointerEvent): void => widen(moved.clientX);
  divider.addEventListener('pointermove', move);
  divider.addEventListener('pointerup', () => divider.removeEventListener('pointermove', move), { once: true });
});
divider.addEventListener('keydown', (event) => {
  if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') widen(left.clientWidth + (event.key === 'ArrowRight' ? 30 : -30));
});

document.body.append(
  el(
    'header',
    {},
    el('h1', {}, texts.title),
    el('button', { class: 'main', onclick: () => void gallery.open() }, texts.gallery),
    el('button', { onclick: () => picker.click() }, texts.open),
    el('button', { onclick: save, title: 'Ctrl+S' }, texts.save),
    copyButton,
    el('button', { onclick: () => void embed() }, texts.embed),
    el('span', { class: 'gap' }),
    languageChooser,
    el('button', { onclick: () => setSize(size - 2), title: texts.smallerHelp }, texts.smaller),
    el('button', { onclick: () => setSize(size + 2), title: texts.largerHelp }, texts.larger),
    themeButton,
    el('button', { onclick: () => present(true), title: texts.help }, texts.present),
    picker,
  ),
  el(
    'main',
    {},
    left,
    divider,
    el(
      'section',
      { id: 'right', 'aria-label': texts.views },
      el(
        'div',
        { class: 'tabs' },
        el('div', { role: 'tablist', 'aria-label': texts.views, onkeydown: tabKeys(tabs, tabButtons) }, ...tabs.map((tab) => tabButtons[tab])),
        el('button', { id: 'leave', onclick: () => present(false) }, texts.leave),
      ),
      ...tabs.map((tab) => panels[tab].root),
    ),
  ),
  gallery.dialog,
  embedDialog,
  el('footer', {}, wholePage),
  el('div', { id: 'spoken', 'aria-live': 'polite' }),
);

addEventListener('keydown', (event) => {
  if ((event.ctrlKey || event.metaKey) && event.key === 's') {
    event.preventDefault();
    save();
  } else if (event.key === 'Escape' && document.body.classList.contains('present')) {
    present(false);
  } else if (document.body.classList.contains('present') && !(event.target instanceof HTMLInputElement)) {
    const panel = panels[state.tab];
    if (!event.defaultPrevented && 'key' in panel) panel.key(event);
  }
});
addEventListener('fullscreenchange', () => {
  if (!document.fullscreenElement && document.body.classList.contains('present')) present(false);
});

async function begin(): Promise<void> {
  document.documentElement.lang = language;
  setTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  if (location.hash.length > 1) await fromLink(location.hash.slice(1), (look) => panels.figure.lookAt(look));
  if (state.embed) void linkToWhole();
  addEventListener('hashchange', () => void fromLink(location.hash.slice(1), (look) => panels.figure.lookAt(look)).then(() => showDocument(documentShown)));
  // A picture that comes at once is on the screen before the editor is made.
  const kind = documentShown;
  await Promise.race([showTab(), later(firstWait)]);
  await Promise.race([new Promise((done) => requestAnimationFrame(() => setTimeout(done))), later(firstWait)]);
  if (kind === documentShown) showDocument(kind);
  void lookAtSystem();
}
const firstWait = 100; // milliseconds
void begin();

/** For the tests that measure: when the last figure was on the canvas. */
Object.assign(window, { algaeFigurePainted: () => panels.figure.painted });
