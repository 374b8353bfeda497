import { defineAlgorithm } from '../algorithm/algorithm.js';
import { nobody, ownedBy } from '../algorithm/owners.js';
import { cells } from '../language/words.js';
import { currentPolygon } from '../picture/event-marks.js';
import { activeDrawing } from '../solid/drawing.js';
import {
  behind,
  entering,
  facts,
  painted,
  parted,
  piercing,
  polygonsAsked,
  sort,
  stack,
  walk,
} from './ask.js';
import { course } from './course.js';
import { figureOf, marks } from './shapes.js';
import { plane } from '../polygons/ask-plane.js';
import { outline } from './outline.js';

defineAlgorithm(['weiler-atherton'], {
  begins: ['pop_list'],
  things: () => [],
  marks,
  figure: figureOf,
  solid: {
    drawing: (view) => activeDrawing(currentPolygon(view)),
    caption: () => [],
  },
  lanes: { first: 'polygons', below: [[], ['calls']] },
  course,
  outline,
  goals: [
    { name: 'list', at: ['pop_list'] },
    { name: 'region', at: ['show'] },
  ],
  owners: (event) => (event.e === 'paint' ? ownedBy(event.polygon) : nobody),
  abouts: {},
  askers: { plane, piercing, sort, parted, entering, walk, behind, stack, painted },
  facts,
  polygonsAsked,
  counts: {
    comparisons: ['behind', 'order'],
    lists: ['pop_list'],
    clips: ['clipped'],
    regions: ['show'],
  },
  sums: [
    {
      counter: 'painted',
      at: ['paint'],
      amount: (event) => (event.e === 'paint' ? cells(event.runs) : 0),
    },
  ],
  landmarks: [],
  landmark: () => null,
});
