import { kinds } from './question.js';
import { countOf, inHundredths } from './score.js';
import type { Count, Score } from './score.js';

/** Keeps the score between visits, and reports it to whoever set the questions. */
export interface Keeper {
  /** The score of earlier visits. */
  readonly earlier: Score | null;
  /** The percentage that it keeps; null if it has refused a score. */
  readonly percent: number | null;
  /** How many more questions it wants to be answered. */
  readonly left: number;
  keep(score: Score): void;
}

const sumOf = (one: Count, other: Count): Count => ({
  asked: one.asked + other.asked,
  right: one.right + other.right,
  given_up: one.given_up + other.given_up,
  points: inHundredths(one.points + other.points),
  parts: one.parts + other.parts,
});

/**
 * The percentage of the points in the questions answered. While fewer questions are answered than are wanted, the others count as
 * wrong ones of the same size.
 */
export function percentOf({ asked, points, parts }: Count, wanted: number): number {
  return parts === 0 ? 0 : inHundredths(((100 * points) / parts) * Math.min(1, asked / wanted));
}

/** The score of earlier visits, and of this one. */
export function joined(earlier: Score | null, score: Score): Score {
  if (earlier === null) return score;
  const kindCounts = kinds.flatMap((kind) => {
    const counts = [earlier, score].flatMap((each) => each.kinds[kind] ?? []);
    return counts.length === 0 ? [] : [[kind, counts.reduce(sumOf)] as const];
  });
  return {
    ...score,
    total: sumOf(earlier.total, score.total),
    kinds: Object.fromEntries(kindCounts),
    runs: [...earlier.runs, ...score.runs],
  };
}

/** The score as a text of at most `most` characters: without its answers if it would be too long with them. */
export function shortScore(score: Score, most: number): string {
  const whole = JSON.stringify(score);
  return whole.length <= most ? whole : JSON.stringify({ ...score, runs: [] });
}

function isCount(value: unknown): boolean {
  const counted = Object(value) as Readonly<Record<string, unknown>>;
  return Object.keys(countOf([])).every((key) => Number.isFinite(counted[key]));
}

function isScore(value: unknown): value is Score {
  const { format, total, kinds: byKind, runs } = Object(value) as Partial<Score>;
  return (
    format === 'vidno-score/1' &&
    isCount(total) &&
    Object(byKind) === byKind &&
    Object.values(byKind as object).every(isCount) &&
    Array.isArray(runs)
  );
}

/** The score in a text that `shortScore` made; null for any other text. */
export function readScore(text: string): Score | null {
  try {
    const value: unknown = JSON.parse(text);
    return isScore(value) ? value : null;
  } catch {
    return null;
  }
}
