import type { FloatingHorizonEvents, Event } from '../trace/events.js';

/** A sample of each event of curves, and several where its sentence has cases. */
export const floatingHorizonSamples: {
  readonly [K in keyof FloatingHorizonEvents]: readonly Event<K>[];
} = {
  horizons: [
    { e: 'horizons', at: 'FH1' },
    { e: 'horizons', at: 'FH1', upper: 0, lower: 200 },
  ],
  curve: [
    { e: 'curve', at: 'FH2', curve: 0 },
    { e: 'curve', at: 'FH2', curve: 3 },
  ],
  side_edge: [
    { e: 'side_edge', at: 'FH3', sample: [0, 2.5] },
    { e: 'side_edge', at: 'FH10', sample: [7, -1] },
  ],
  visibility: ([1, -1, 0, 2] as const).map((flag) => ({
    e: 'visibility',
    at: flag === 2 ? 'FH4' : 'FH5',
    segment: [0, 4],
    x: 3,
    flag,
    exact: flag,
    by: 'operands',
  })),
  intersection: [
    { e: 'intersection', at: 'FH7', segment: [0, 4], point: ['7/3', 2.5], columns: [2, 3] },
    { e: 'intersection', at: 'FH8', segment: [0, 4], point: [3, 2.5], columns: [3, 3] },
  ],
  draw_line: [
    {
      e: 'draw_line',
      at: 'FH6',
      segment: [0, 4],
      from: [0, 2],
      fromColumns: [0, 0],
      to: ['5/2', '9/4'],
      toColumns: [2, 3],
    },
    {
      e: 'draw_line',
      at: 'FH8',
      segment: [0, 4],
      from: [3, 2],
      fromColumns: [3, 3],
      to: [3, 2],
      toColumns: [3, 3],
    },
  ],
  horizon: [
    { e: 'horizon', at: 'SE2', first: 4, last: 2, upper: [], lower: [] },
    { e: 'horizon', at: 'FH6', first: 2, last: 2, upper: [], lower: [] },
    {
      e: 'horizon',
      at: 'FH6',
      first: 1,
      last: 2,
      upper: [
        [1, 2],
        [2, '9/4'],
      ],
      lower: [[1, 2]],
    },
  ],
  height: [
    { e: 'height', at: 'V1', x: 3, y: 2 },
    { e: 'height', at: 'V1', x: 3, y: '7/3', upper: 2, lower: 5 },
  ],
  raise: [{ e: 'raise', at: 'H2', x: 3, y: 1.5 }],
  lower: [{ e: 'lower', at: 'H3', x: 3, y: '7/3' }],
  step: [
    { e: 'step', at: 'IN2', x: 3, changes: true },
    { e: 'step', at: 'IN2', x: 4, changes: false },
  ],
};
