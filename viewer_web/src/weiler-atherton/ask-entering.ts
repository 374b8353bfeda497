import { polygonThing } from '../algorithm/pointed.js';
import { point } from '../language/words.js';
import { inOrder, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import { mostOptions, pointOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Option, Part } from '../predict/question.js';
import { clippingAt } from './pieces.js';

/** The part that asks for some of the points. */
function pointsPart(
  asks: 'enters' | 'leaves',
  options: readonly Option[],
  steps: readonly Step<'entering' | 'leaving'>[],
): Part {
  return {
    asks,
    options,
    right: steps.map(({ event }) => point(event.point)),
    decidedBy: (value) => steps.find(({ event }) => point(event.point) === value)?.step,
  };
}

/** Where does the outline enter the clip polygon, and where does it leave it? */
export const entering: Asker<'entering'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    const clipping = clippingAt(trace, step);
    if (clipping === null) return null;
    const { clip, outline, result } = clipping;
    const options = pointOptions(outline.map(({ from }) => from));
    const points = new Set(options.map(({ value }) => value));
    if (options.length > mostOptions || points.size < options.length) return null;
    const until = result.step;
    const enters = stepsOf(trace, step, until, 'entering');
    const leaves = stepsOf(trace, step, until, 'leaving');
    const { polygon } = result.event;
    return {
      kind: 'entering',
      step,
      until,
      about: { polygon, clip: clip[0] },
      parts: [pointsPart('enters', options, enters), pointsPart('leaves', options, leaves)],
      because: inOrder(stepsOf(trace, step, until, 'edge_piece'), enters, leaves, [result]),
      things: [polygon, clip[0]].map(polygonThing),
    };
  },
};
