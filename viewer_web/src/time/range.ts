/** A part of a run: the steps from one to another, both included. */
export interface Range {
  readonly from: number;
  readonly to: number;
}

/** A strip shows at least this number of steps, unless the run has fewer. */
const least = 8;
/** The share of a range that stays behind the step that it follows. */
const behind = 0.1;

export const wholeOf = (length: number): Range => ({ from: 0, to: length });

export const isIn = ({ from, to }: Range, step: number): boolean => from <= step && step <= to;

export const isWhole = ({ from, to }: Range, length: number): boolean =>
  from === 0 && to === length;

const clamp = (value: number, low: number, high: number): number =>
  Math.min(Math.max(low, value), high);

/** A range of the given number of steps within a run, beginning as near as possible to the wanted step. */
function within(from: number, span: number, length: number): Range {
  const size = clamp(span, Math.min(least, length), length);
  const start = clamp(from, 0, length - size);
  return { from: start, to: start + size };
}

/** The part between two steps, in any order. */
export function between(one: number, other: number, length: number): Range {
  const [from, span] = [Math.min(one, other), Math.abs(other - one)];
  return within(from - Math.max(0, least - span) / 2, span, length);
}

/** Magnifies by a factor, and keeps the place of a step. */
export function zoomed({ from, to }: Range, by: number, at: number, length: number): Range {
  const span = clamp((to - from) / by, Math.min(least, length), length);
  const share = to === from ? 0 : (at - from) / (to - from);
  return within(at - share * span, span, length);
}

/** Moves the range later by a number of steps. */
export function moved({ from, to }: Range, by: number, length: number): Range {
  return within(from + by, to - from, length);
}

/**
 * A range that contains a step: the same one, or, if the step has left it, one that leaves room to continue in that
 * direction.
 */
export function following(range: Range, step: number, length: number): Range {
  if (isIn(range, step)) return range;
  const span = range.to - range.from;
  const before = step > range.to ? behind : 1 - behind;
  return within(step - before * span, span, length);
}

/** The range in whole steps. */
export const inSteps = ({ from, to }: Range): Range => ({
  from: Math.round(from),
  to: Math.round(to),
});
