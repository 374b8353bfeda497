import { defineAlgorithm } from '../algorithm/algorithm.js';
import { columnThing, curveThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import type { Event } from '../trace/events.js';
import { flags, horizons, meeting, sideEdge } from './ask.js';
import { figureOf } from './shapes.js';
import { outline } from './outline.js';

/** The curves, and the columns examined last, since there may be thousands of columns. */
function things({ header, after: { floatingHorizon } }: View): readonly string[] {
  const { previous = null, current = null } = floatingHorizon?.place ?? {};
  return [
    ...(header.scene.curves ?? []).map((_, i) => curveThing(i)),
    ...[previous, current].flatMap((looked) => (looked === null ? [] : [columnThing(looked[0])])),
  ];
}

/** A curve is begun once, and examined once over each column. */
function landmark(event: Event, current: string): string | null {
  if (event.e === 'curve') return `curve ${event.curve}`;
  return event.e === 'visibility' ? `column ${event.x} ${current}` : null;
}

defineAlgorithm(['floating-horizon'], {
  begins: ['curve'],
  things,
  marks: () => [],
  figure: figureOf,
  lanes: { first: 'curves', below: [[], ['calls']] },
  /** The current item is a curve. */
  course: ({ begin, eventAt }) => ({
    curve: (step) => {
      const event = eventAt(step);
      if (event?.e === 'curve') begin(step, event.curve);
    },
  }),
  outline,
  goals: [
    { name: 'curve', at: ['curve'] },
    { name: 'crossing', at: ['intersection'] },
  ],
  abouts: {},
  askers: { flags, horizons, sideEdge, meeting },
  facts: () => [],
  polygonsAsked: () => [],
  counts: { curves: ['curve'], flags: ['visibility'], crossings: ['intersection'] },
  sums: [],
  landmarks: ['curve', 'visibility'],
  landmark,
});
