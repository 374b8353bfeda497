import { defineAlgorithm } from '../algorithm/algorithm.js';
import { nobody, ownedBy } from '../algorithm/owners.js';
import { cells } from '../language/words.js';
import { polygonInHand } from '../picture/in-hand.js';
import { activeDrawing } from '../solid/drawing.js';
import { behind } from './ask-behind.js';
import { entering } from './ask-entering.js';
import { painted } from './ask-painted.js';
import { parted } from './ask-parted.js';
import { piercing } from './ask-piercing.js';
import { sort } from './ask-sort.js';
import { stack } from './ask-stack.js';
import { walk } from './ask-walk.js';
import { course } from './course.js';
import { facts, polygonsAsked } from './facts.js';
import { figureOf } from './figure.js';
import { marks } from './marks.js';
import { plane } from '../polygons/ask-plane.js';
import { notes } from './notes.js';
import { outline } from './outline.js';

defineAlgorithm(['weiler-atherton'], {
  notes,
  begins: ['pop_list'],
  things: () => [],
  marks,
  figure: figureOf,
  solid: {
    drawing: (view) => activeDrawing(polygonInHand(view)),
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
