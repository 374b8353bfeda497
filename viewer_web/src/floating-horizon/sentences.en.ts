import type { Sentences } from '../language/texts.js';
import { point, short, shortApart } from '../language/words.js';
import { isPoint } from '../replay/lines.js';
import type { CurveEvents } from '../trace/events.js';
import type { Flag } from './events.js';
import { isLostBelow, metBy } from './sides.js';

const columns = { one: 'column', other: 'columns' };

const where = ([left, right]: readonly [number, number]): string =>
  left === right
    ? `over column ${short(left)}`
    : `between the columns ${short(left)} and ${short(right)}`;

const names = { upper: 'the upper horizon', lower: 'the lower horizon' } as const;

const flags: Readonly<Record<`${Flag}`, string>> = {
  1: 'on the upper horizon or above it, and visible (1)',
  '-1': 'on the lower horizon or below it, and visible (−1)',
  0: 'strictly between the horizons, and hidden (0)',
  2: 'on both horizons, or there are none yet, and visible (2)',
};

/** The printed text draws nothing between two such points (X-H1). */
const lostBelow = 'on the lower horizon or below it (−1)';

export const sentences: Pick<Sentences, keyof CurveEvents> = {
  horizons: ({ upper, lower }) =>
    upper === undefined || lower === undefined
      ? 'There is no horizon over any column yet.'
      : `Over every column the upper horizon begins at ${short(upper)}, the lower one at ${short(lower)}.`,
  curve: ({ curve }) =>
    curve === 0 ? 'The first curve, 0, is the nearest.' : `Curve ${curve} is the next one.`,
  side_edge: ({ at, sample }) =>
    `The ${at === 'FH3' ? 'left' : 'right'} side edge now ends at ${point(sample)}.`,
  visibility: ({ x, flag }, { after, header }) => {
    const told = after.horizon?.told ?? null;
    const at = told?.x === x ? ` at ${short(told.y)}` : '';
    const isLost = isLostBelow(flag, header.edition);
    return `Over column ${short(x)} the curve${at} is ${isLost ? lostBelow : flags[flag]}.`;
  },
  intersection: ({ at, point: met, columns: between }, { after }) => {
    const horizon = metBy(at, after.horizon ?? null);
    return `The segment meets ${horizon === null ? 'the horizon' : names[horizon]} at ${point(met)}, ${where(between)}.`;
  },
  draw_line: (event) => {
    const { at, from, to } = event;
    if (isPoint(event)) return `The curve is visible at the point ${point(from)}.`;
    const why = {
      FH6: 'it is on one side all the way',
      FH7: 'then a horizon hides it, or it changes sides',
      FH8: 'before, a horizon hid it, or it was on the other side',
    }[at];
    return `The curve is drawn from ${point(from)} to ${point(to)}: ${why}.`;
  },
  horizon: ({ first, last, upper, lower }, words) => {
    if (last < first) return 'No column lies between: the horizons stay as they are.';
    const over =
      first === last ? `Column ${short(first)}` : `Columns ${short(first)} to ${short(last)}`;
    if (upper.length + lower.length === 0) return `${over}: both horizons stay as they are.`;
    const raised = `the upper horizon rises over ${words.counted(upper.length, columns)}`;
    const lowered = `the lower horizon falls over ${words.counted(lower.length, columns)}`;
    if (lower.length === 0) return `${over}: ${raised}.`;
    return upper.length === 0 ? `${over}: ${lowered}.` : `${over}: ${raised}, ${lowered}.`;
  },
  height: ({ x, y, upper, lower }) => {
    if (upper === undefined || lower === undefined) {
      return `Over column ${short(x)} the curve is at ${short(y)}; no horizon is there.`;
    }
    const [own, above] = shortApart(y, upper);
    const [, below] = shortApart(y, lower);
    return `Over column ${short(x)} the curve is at ${own}; the upper horizon is at ${above}, the lower one at ${below}.`;
  },
  raise: ({ x, y }) => `Over column ${short(x)} the upper horizon comes to ${short(y)}.`,
  lower: ({ x, y }) => `Over column ${short(x)} the lower horizon comes to ${short(y)}.`,
  step: ({ x, changes }) =>
    changes
      ? `Over column ${short(x)} the segment is on the other side of the horizon: they meet on the way here.`
      : `Over column ${short(x)} the segment is still on the same side of the horizon.`,
};
