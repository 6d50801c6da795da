// The texts of the page in the language that was chosen, or that the browser asks for, or in English.

import { cs } from './cs';
import { en, type Texts } from './en';
import { pt } from './pt';
import { ru } from './ru';

export const languages: Record<string, Texts> = { en, pt, cs, ru };

const place = 'algae-language';

function chosen(): string {
  try {
    const kept = localStorage.getItem(place);
    if (kept && kept in languages) return kept;
  } catch {
    // a page may be shown where nothing can be kept
  }
  for (const wanted of navigator.languages) {
    const language = wanted.split('-')[0]!.toLowerCase();
    if (language in languages) return language;
  }
  return 'en';
}

export const language = chosen();
export const texts: Texts = languages[language]!;

/** Keeps the choice for the next time the page is loaded; false where nothing can be kept. */
export function choose(wanted: string): boolean {
  try {
    localStorage.setItem(place, wanted);
    return true;
  } catch {
    return false;
  }
}
