import { box } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';
import { isSeen, sortedBy } from './finding.js';
import type { Finding } from './finding.js';

/** The most marks: more would cover the whole picture. */
const most = 400;

/** What lies on top: wrong decisions over narrow ones, those over zeros. */
const marked = ['zero', 'narrow', 'wrong'] as const;
type Marked = (typeof marked)[number];
const isMarked = (kind: Finding['kind']): kind is Marked =>
  (marked as readonly string[]).includes(kind);

/**
 * The pixels decided wrongly, narrowly or by exact zeros, each once for each of these. Decisions about a whole window or more
 * are marked at their step only.
 */
export function findingMarks(findings: readonly Finding[], step: number): readonly Mark[] {
  const seen = new Set<string>();
  const marks: Readonly<Record<Marked, Mark[]>> = { zero: [], narrow: [], wrong: [] };
  // Wrong decisions come first, so that none is left out.
  const important = sortedBy('kind', findings.filter(isSeen));
  for (const { pixels, kind, step: own } of important) {
    const [, , width, height] = pixels;
    const isOne = width === 1 && height === 1;
    if (!isMarked(kind) || (!isOne && own !== step)) continue;
    const key = `${kind} ${pixels.join(' ')}`;
    if (seen.has(key) || seen.size >= most) continue;
    seen.add(key);
    marks[kind].push(box(kind, pixels));
  }
  return marked.flatMap((kind) => marks[kind]);
}

/** The steps to mark on the strip: for each kind at most one in each of `places` places. */
export function findingSteps(
  findings: readonly Finding[],
  length: number,
  places = 300,
): readonly { readonly step: number; readonly kind: Marked }[] {
  const seen = new Set<string>();
  return findings.filter(isSeen).flatMap(({ step, kind }) => {
    if (!isMarked(kind)) return [];
    const key = `${kind} ${Math.floor((step / Math.max(1, length)) * places)}`;
    if (seen.has(key)) return [];
    seen.add(key);
    return [{ step, kind }];
  });
}
