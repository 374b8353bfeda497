import { defineAlgorithm } from '../algorithm/algorithm.js';
import type { Algorithm } from '../algorithm/algorithm.js';
import { nobody, ownedBy } from '../algorithm/owners.js';
import { cornerThing, windowThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { cells } from '../language/words.js';
import { figureOf } from '../picture/figure.js';
import { corners, hasWindows, methods } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import { abouts } from './about.js';
import { plane } from '../polygons/ask-plane.js';
import {
  clip,
  corners as cornersAsked,
  depth,
  edgeDepth,
  facing,
  facts,
  fill,
  inside,
  octants,
  point,
  polygonsAsked,
  pop,
  ray,
  relation,
  split,
  trial,
  window,
} from './ask.js';
import { course, goals } from './course.js';
import { marks, thingMarks } from './marks.js';
import { ownersOf } from './naming.js';
import { outline } from './outline.js';
import { caption, drawing, pointed } from './solid.js';

/** The corners of the current window, and the windows on the stack from the top. */
function things({ after: { warnock } }: View): readonly string[] {
  if (warnock === undefined) return [];
  return [
    ...(warnock.corners === null ? [] : corners.map(cornerThing)),
    ...warnock.stack.map(({ window: each }) => windowThing(each)).reverse(),
  ];
}

/** A window is popped once, and decided once. */
function landmark(event: Event, current: string): string | null {
  if (event.e === 'pop') return `window ${event.window.join()}`;
  return event.e === 'decide' ? `decide ${current}` : null;
}

const sums: Algorithm['sums'] = [
  {
    counter: 'splits',
    at: ['decide'],
    amount: (event) => (event.e === 'decide' && event.case === 'split' ? 1 : 0),
  },
  {
    counter: 'painted',
    at: ['fill', 'draw'],
    amount(event) {
      if (event.e === 'fill') return event.rect[2] * event.rect[3];
      return event.e === 'draw' ? cells(event.runs) : 0;
    },
  },
];

defineAlgorithm(methods.filter(hasWindows), {
  begins: ['pop'],
  things,
  marks,
  thingMarks,
  figure: figureOf,
  solid: { drawing, pointed, caption },
  lanes: { first: 'cases', below: [['levels'], ['levels', 'calls']] },
  course,
  outline,
  goals,
  owners(event, known, header) {
    if (event.e === 'fill') return ownersOf(event, known, header);
    return event.e === 'draw' ? ownedBy(event.polygon) : nobody;
  },
  abouts,
  askers: {
    plane,
    facing,
    window,
    pop,
    split,
    relation,
    trial,
    ray,
    octants,
    corners: cornersAsked,
    depth,
    edgeDepth,
    inside,
    point,
    clip,
    fill,
  },
  facts,
  polygonsAsked,
  counts: {
    windows: ['pop'],
    surrounds: ['surround'],
    relations: ['relation'],
    comparisons: ['compare'],
    sides: ['clip_side'],
  },
  sums,
  landmarks: ['pop', 'decide'],
  landmark,
});
