import type { Inline, Inlines } from './story.js';

/** A formula and the signs before and after it, which must stand on its line. */
export interface Glued {
  readonly is: 'glued';
  readonly before: string;
  readonly tex: string;
  readonly after: string;
}

const opening = /[([{«„“‘]+$/u;
const closing = /^(?:[)\]}»”’.,;:!?…]+|[-‑]\p{L}*)/u;

/** The coordinates of a point stay on one line. */
export function withWholePoints(text: string): string {
  return text.replace(/\([−\d.,;/ ]{3,24}\)/gu, (point) => point.replaceAll(' ', '\u00a0'));
}

/** To a browser a line may end before and after a formula, whatever stands there. */
export function glued(inlines: Inlines): readonly (Inline | Glued)[] {
  const rest = [...inlines];
  const result: (Inline | Glued)[] = [];
  rest.forEach((inline, i) => {
    // Its beginning may have been taken by the formula before it.
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
