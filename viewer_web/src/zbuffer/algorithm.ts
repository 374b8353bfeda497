import { defineAlgorithm } from '../algorithm/algorithm.js';
import { nobody, ownedBy } from '../algorithm/owners.js';
import { edgeThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { cells } from '../language/words.js';
import { figureOf } from '../picture/figure.js';
import type { Event } from '../trace/events.js';
import { abouts } from './about.js';
import { plane } from '../polygons/ask-plane.js';
import { ael, facts, pixels, polygonsAsked } from './ask.js';
import { changesAel, course, goals } from './course.js';
import { marks, thingMarks } from './marks.js';
import { outline } from './outline.js';
import { caption, drawing, pointed } from './solid.js';

/** The edges of the current polygon, the active ones first. */
function things({ after: { zbuffer } }: View): readonly string[] {
  if (zbuffer === undefined) return [];
  return [...zbuffer.ael.map(({ edge }) => edge), ...zbuffer.edges].map(edgeThing);
}

/** A polygon is begun once, and has each row once. */
function landmark(event: Event, current: string): string | null {
  if (event.e === 'polygon') return `polygon ${event.polygon}`;
  return event.e === 'scanline' ? `row ${event.row} ${current}` : null;
}

defineAlgorithm(['zbuffer'], {
  begins: ['polygon'],
  things,
  marks,
  thingMarks,
  figure: figureOf,
  solid: { drawing, pointed, caption },
  lanes: { first: 'polygons', below: [[], ['ael', 'calls']] },
  course,
  outline,
  goals,
  owners: (_event, { zbuffer }) => (zbuffer?.polygon == null ? nobody : ownedBy(zbuffer.polygon)),
  abouts,
  askers: { plane, ael, pixels },
  facts,
  polygonsAsked,
  counts: { comparisons: ['pixel'] },
  sums: [
    {
      counter: 'ael',
      at: ['ael_add', 'ael_drop'],
      amount: (event) => (changesAel(event) ? 1 : 0),
    },
    {
      counter: 'painted',
      at: ['span'],
      amount: (event) => (event.e === 'span' ? cells(event.runs) : 0),
    },
  ],
  landmarks: ['polygon', 'scanline'],
  landmark,
});
