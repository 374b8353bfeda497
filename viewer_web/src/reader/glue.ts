import type { Inline, Inlines } from './story.js';

/** A formula and the characters before and after it, which must be on the same line. */
export interface Glued {
  readonly is: 'glued';
  readonly before: string;
  readonly tex: string;
  readonly after: string;
}

const opening = /[([{«„“‘]+$/u;
const closing = /^(?:[)\]}»”’.,;:!?…]+|[-‑]\p{L}*)/u;

/** Keeps on one line the coordinates of a point, the two sides of an area, a number, and a dash with the word before it. */
export function withoutBadBreaks(text: string): string {
  return text.replace(/\([−±\d.,;/ ]{3,24}\)|\d × (?=\d)|\d (?=\d{3}(?!\d))| (?=— )/gu, (whole) =>
    whole.replaceAll(' ', '\u00a0'),
  );
}

/** Browsers allow a line break before and after a formula, whatever character is there. */
export function glued(inlines: Inlines): readonly (Inline | Glued)[] {
  const rest = [...inlines];
  const result: (Inline | Glued)[] = [];
  rest.forEach((inline, i) => {
    // The preceding formula may have taken its beginning.
    const own = rest[i] ?? inline;
    if (typeof own === 'string' || own.is !== 'formula') {
      result.push(own);
      return;
    }
    const last = result.at(-1);
    const next = rest[i + 1];
    const before = typeof last === 'string' ? (opening.exec(last)?.[0] ?? '') : '';
    const after = typeof next === 'string' ? (closing.exec(next)?.[0] ?? '') : '';
    if (typeof last === 'string')
      result[result.length - 1] = last.slice(0, last.length - before.length);
    if (typeof next === 'string') rest[i + 1] = next.slice(after.length);
    result.push({ is: 'glued', before, tex: own.tex, after });
  });
  return result;
}
