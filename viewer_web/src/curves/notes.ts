import { point, short } from '../i18n/words.js';
import type { CurveEvents } from '../trace/events.js';
import type { N } from '../trace/values.js';

const height = (y: N | undefined): string => (y === undefined ? '∅' : short(y));

/** What the events of curves say in the notation of the listing. */
export const curveNotes: {
  readonly [K in keyof CurveEvents]: (event: CurveEvents[K]) => string;
} = {
  horizons: ({ upper, lower }) => `${height(upper)}, ${height(lower)}`,
  curve: ({ curve }) => String(curve),
  side_edge: ({ sample }) => point(sample),
  visibility: ({ at, flag }) => `${at === 'FH4' ? 'Pflag' : 'Tflag'} = ${short(flag)}`,
  intersection: ({ point: met }) => point(met),
  draw_line: ({ from, to }) => `${point(from)} → ${point(to)}`,
  horizon: ({ first, last }) => (last < first ? '∅' : `[${first}, ${last}]`),
  height: ({ y, upper, lower }) => [y, upper, lower].map(height).join(', '),
  raise: ({ x, y }) => `[${x}] := ${short(y)}`,
  lower: ({ x, y }) => `[${x}] := ${short(y)}`,
  step: ({ x, changes }) => `${x}: ${String(changes)}`,
};
