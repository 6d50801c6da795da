// Words that change with a number, by the rules of a language that every browser knows (Unicode, plural rules).

export type Counted = (count: number) => string;
export type Forms = Partial<Record<Intl.LDMLPluralRule, string>> & { other: string };

/** The form of a word for a number, in a language: plurals('cs')({ one: 'slovo', few: 'slova', other: 'slov' })(3) is 'slova'. */
export function plurals(language: string): (forms: Forms) => Counted {
  const rules = new Intl.PluralRules(language);
  return (forms) => (count) => forms[rules.select(count)] ?? forms.other;
}
