import { polygonThing } from '../algorithm/pointed.js';
import { inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import { mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Part } from '../predict/question.js';
import type { Piece } from '../trace/values.js';
import { ownersOf } from './pieces.js';

/** More outlines than most parts have. */
const counts = ['0', '1', '2', '3', '4'];

/** Asks for the number of outlines of a part outside, preferably one with several, where mistakes are likely. */
function outlinesOf(
  others: readonly Piece[],
  clipped: readonly Step<'clipped'>[],
  step: number,
): Part | null {
  const piecesOf = (polygon: string): number => others.filter(([id]) => id === polygon).length;
  const asked = clipped.filter(
    ({ event }) => event.outside.length < counts.length && piecesOf(event.polygon) === 1,
  );
  const several = asked.find(({ event }) => event.outside.length > 1);
  const one = (several ?? asked[step % asked.length])?.event;
  if (one === undefined) return null;
  return {
    asks: 'outlines',
    options: optionsOf(counts),
    right: [String(one.outside.length)],
    given: [{ value: one.polygon, of: 'polygon' }],
  };
}

/** Which parts of a list are inside the clip polygon, and which are outside? */
export const parted: Asker<'parted'> = {
  from: 'polygons',
  at: ['pop_list'],
  ask(trace, step) {
    const end = nextOf(trace, step, 'nearer_ones', 'pop_list');
    const [clip, ...others] = trace.timeline.seek(step).values.weilerAtherton?.inHand?.pieces ?? [];
    if (end === null || clip === undefined) return null;
    const clipped = stepsOf(trace, step, end.step, 'clipped');
    const beside = stepsOf(trace, step, end.step, 'beside');
    const because = inOrder(clipped, beside);
    const until = because.at(-1);
    const ids = ownersOf(others);
    const outlines = outlinesOf(others, clipped, step);
    if (until === undefined || clipped.length === 0 || ids.length > mostOptions) return null;
    if (outlines === null && ids.length < 2) return null;
    const polygonsOf = (steps: readonly Step<'clipped' | 'beside'>[]): readonly string[] => [
      ...new Set(steps.map(({ event }) => event.polygon)),
    ];
    const within = clipped.filter(({ event }) => event.inside.length > 0);
    const beyond = clipped.filter(({ event }) => event.outside.length > 0);
    return {
      kind: 'parted',
      step,
      until,
      about: { clip: clip[0], pieces: others.length + 1 },
      parts: [
        { asks: 'within', options: optionsOf(ids), right: polygonsOf(within) },
        { asks: 'beyond', options: optionsOf(ids), right: polygonsOf([...beside, ...beyond]) },
        ...(outlines === null ? [] : [outlines]),
      ],
      because,
      things: [clip[0], ...ids].map(polygonThing),
    };
  },
};
