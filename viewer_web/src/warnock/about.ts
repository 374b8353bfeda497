import { depths, isSegment, last, spotOf, verticesOf } from '../exactness/about.js';
import type { About, Abouts } from '../exactness/mapped-decision.js';
import { cornerOf } from '../picture/mark.js';
import type { Trace } from '../replay/trace.js';
import type { Event } from '../trace/events.js';
import type { Corner } from '../trace/values.js';

/** S2, S3: (to - from) x (point - from). */
function orientation(trace: Trace, { polygon, edge, point }: Event<'orient'>): About {
  const vertices = verticesOf(trace, polygon);
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  if (from === undefined || to === undefined) return null;
  return [spotOf(point), { orientation: { q: spotOf(from), r: spotOf(to), pivot: 'q' } }];
}

/** PL3, PL4: the differences are relative to the side's second corner, F_i. */
function sideOf(trace: Trace, { vertex }: Event<'clip_sign'>, step: number): About {
  const side = last(trace, step, 'clip_side');
  if (side === null) return null;
  const { from, to } = side.event;
  return [spotOf(vertex), { orientation: { q: spotOf(from), r: spotOf(to), pivot: 'r' } }];
}

/** PW6, HP4, PC4: compared with the nearest polygon so far. */
function nearer(trace: Trace, { polygon, corner }: Event<'compare'>, step: number): About {
  const pop = last(trace, step, 'pop');
  if (pop === null) return null;
  const { window } = pop.event;
  const owner =
    corner === undefined
      ? last(trace, step, 'nearest', pop.step)?.event.polygon
      : ownerOf(trace, step, corner, pop.step);
  const at =
    corner === undefined ? last(trace, step, 'depth')?.event.point : cornerOf(window, corner);
  return owner && at ? depths(trace, at, polygon, owner) : null;
}

/** The polygon with the stored depth at a corner of the window: the last one that was nearer there. */
function ownerOf(trace: Trace, step: number, corner: Corner, since: number): string | null {
  let found = last(trace, step, 'nearer', since);
  while (found !== null && !found.event.corners.includes(corner)) {
    found = last(trace, found.step - 1, 'nearer', since);
  }
  return found?.event.polygon ?? null;
}

export const abouts: Abouts = {
  orient: orientation,
  clip_sign: sideOf,
  surround: (trace, { polygon, point }) =>
    isSegment(trace, polygon)
      ? null
      : [spotOf(point), { surround: { polygon: verticesOf(trace, polygon).map(spotOf) } }],
  compare: nearer,
};
