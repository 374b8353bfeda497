import { box } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';
import { isSeen } from './finding.js';
import type { Finding } from './finding.js';

/** More would be a carpet. */
const most = 400;

/**
 * The pixels that exact zeros and narrow decisions decided, each once; those that decide a whole window or more are shown at
 * their step alone.
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

/** The steps to be marked on the strip: those of each kind once for each of so many places. */
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
