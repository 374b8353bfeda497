/**
 * What the library says of a step: one line; or what the run computed, on a second line what is so instead, and on a third the
 * pixel that shows it, "x y", if it is about one.
 */
export type Stated = string;

/** Whether something else is so than the run computed. */
export const isCorrected = (text: Stated): boolean => text.includes('\n');

/** The pixel that shows what is so instead. */
export function correctedPixel(text: Stated): readonly [x: number, y: number] | null {
  const [, , place] = text.split('\n');
  if (place === undefined) return null;
  const [x = NaN, y = NaN] = place.split(' ').map(Number);
  return [x, y];
}

/** What the run computed, and what is so instead if it is something else. */
export const sentencesOf = (text: Stated): readonly string[] => text.split('\n').slice(0, 2);

export const inOneLine = (text: Stated): string => sentencesOf(text).join(' ');
