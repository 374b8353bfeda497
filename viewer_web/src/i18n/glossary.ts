import entries from '../../../lessons/glossary.json';
import type { Bilingual, Language } from '../language/language.js';

/** A term of the course in one language. In `find` and `never`, `*` stands for any letters. */
export interface Term {
  readonly term: string;
  /** The forms in which a text uses the term. */
  readonly find: readonly string[];
  /** The words to avoid for it. */
  readonly never: readonly string[];
  /** What it means, in one line. */
  readonly line: string;
}

export const glossary: readonly Bilingual<Term>[] = entries;

const letter = '[a-zа-яё]';
const partOfWord = '[a-zа-яё0-9_-]';

/**
 * Finds whole words that match one of the forms, in a text in lower case. The flag `i` and `\p{L}` would do the same, but take
 * a second to compile.
 */
export function wordsLike(forms: readonly string[]): RegExp {
  const escaped = forms.map((form) =>
    form
      .toLowerCase()
      .replace(/[.+?^${}()|[\]\\]/g, '\\$&')
      .replaceAll('*', `${letter}*`),
  );
  return new RegExp(`(?<!${partOfWord})(?:${escaped.join('|')})(?!${partOfWord})`, 'g');
}

/** A piece of a text, with the term that it is an occurrence of. */
export interface Piece {
  readonly text: string;
  readonly term: Term | null;
}

/** Splits texts at the first occurrence of each term. */
export class FirstTerms {
  private static readonly forms: Partial<Record<Language, RegExp>> = {};
  private readonly seen = new Set<Term>();

  constructor(
    private readonly language: Language,
    /** Whether a word is a name that merely looks like a term. */
    private readonly isName: (word: string) => boolean = () => false,
  ) {}

  /** Forgets the terms seen so far, as at the start of a section. */
  forget(): void {
    this.seen.clear();
  }

  split(text: string): readonly Piece[] {
    const { language } = this;
    // The longest form first, so that "surrounding polygon" is not taken for "surrounding".
    const forms = (FirstTerms.forms[language] ??= wordsLike(
      glossary.flatMap((entry) => entry[language].find).sort((a, b) => b.length - a.length),
    ));
    const pieces: Piece[] = [];
    let end = 0;
    for (const { 0: lower, index } of text.toLowerCase().matchAll(forms)) {
      const found = text.slice(index, index + lower.length);
      const term = termOf(found, language);
      if (term === null || this.seen.has(term) || this.isName(found)) continue;
      this.seen.add(term);
      if (index > end) pieces.push({ text: text.slice(end, index), term: null });
      pieces.push({ text: found, term });
      end = index + found.length;
    }
    if (end < text.length) pieces.push({ text: text.slice(end), term: null });
    return pieces;
  }
}

const terms = new Map<string, Term | null>();

function termOf(found: string, language: Language): Term | null {
  const lower = found.toLowerCase();
  const key = `${language} ${lower}`;
  let term = terms.get(key);
  if (term === undefined) {
    const whole = (each: Term): boolean =>
      [...lower.matchAll(wordsLike(each.find))].some(([match]) => match === lower);
    term = glossary.map((entry) => entry[language]).find(whole) ?? null;
    terms.set(key, term);
  }
  return term;
}
