import { box } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';
import { isSeen } from './finding.js';
import type { Finding } from './finding.js';

/** The most marks: more would cover the whole picture. */
const most = 400;

/**
 * The pixels decided by exact zeros and narrow decisions, each once. Decisions about a whole window or more are marked at
 * their step only.
 */
export function findingMarks(findings: readonly Finding[], step: number): readonly Mark[] {
  const seen = new Set<string>();
  const marks: Mark[] = [];
  for (const { pixels, kind, step: own } of findings.filter(isSeen)) {
    const [, , width, height] = pixels;
    const isOne = width === 1 && height === 1;
    if (kind === 'wrong' || kind === 'point' || (!isOne && own !== step)) continue;
    const key = `${kind} ${pixels.join(' ')}`;
    if (seen.has(key) || seen.size >= most) continue;
    seen.add(key);
    marks.push(box(kind, pixels));
  }
  return marks;
}

/** The steps to mark on the strip: for each kind at most one in each of `places` places. */
export function findingSteps(
  findings: readonly Finding[],
  length: number,
  places = 300,
): readonly { readonly step: number; readonly kind: 'zero' | 'narrow' }[] {
  const seen = new Set<string>();
  return findings.filter(isSeen).flatMap(({ step, kind }) => {
    if (kind !== 'zero' && kind !== 'narrow') return [];
    const key = `${kind} ${Math.floor((step / Math.max(1, length)) * places)}`;
    if (seen.has(key)) return [];
    seen.add(key);
    return [{ step, kind }];
  });
}
