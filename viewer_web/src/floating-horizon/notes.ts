import type { Numbers } from '../language/texts.js';
import type { Notes } from '../listing/notes.js';
import type { FloatingHorizonEvents } from '../trace/events.js';
import type { N } from '../trace/values.js';

const heights = (all: readonly (N | undefined)[], { list }: Numbers): string =>
  list(all.map((y) => y ?? '∅'));

/** The notes of the events of curves, in the notation of the listing. */
export const notes: Pick<Notes, keyof FloatingHorizonEvents> = {
  horizons: ({ upper, lower }, numbers) => heights([upper, lower], numbers),
  curve: ({ curve }) => String(curve),
  side_edge: ({ sample }, { point }) => point(sample),
  visibility: ({ at, flag }, { short }) => `${at === 'FH4' ? 'Pflag' : 'Tflag'} = ${short(flag)}`,
  intersection: ({ point: met }, { point }) => point(met),
  draw_line: ({ from, to }, { point }) => `${point(from)} → ${point(to)}`,
  horizon: ({ first, last }, { list }) => (last < first ? '∅' : `[${list([first, last])}]`),
  height: ({ y, upper, lower }, numbers) => heights([y, upper, lower], numbers),
  raise: ({ x, y }, { short }) => `[${x}] := ${short(y)}`,
  lower: ({ x, y }, { short }) => `[${x}] := ${short(y)}`,
  step: ({ x, changes }) => `${x}: ${String(changes)}`,
};
