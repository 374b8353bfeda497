import type { Event, WeilerAthertonEvents } from '../trace/events.js';

const square = [
  [
    [0, 0],
    [4, 0],
    [4, 4],
    [0, 4],
  ],
] as const;
const hole = [
  ['3/1', '1/1'],
  ['1/1', '1/1'],
  ['1/1', '3/1'],
  ['3/1', '3/1'],
] as const;
const ring = [...square, hole];

/** A sample of each event of Weiler and Atherton's algorithm, and several where its sentence has cases. */
export const weilerAthertonSamples: {
  readonly [K in Exclude<keyof WeilerAthertonEvents, 'row'>]: readonly Event<K>[];
} = {
  cut_to_area: [
    { e: 'cut_to_area', at: 'WA1', polygon: 'A', region: square },
    { e: 'cut_to_area', at: 'WA1', polygon: 'A', region: [] },
  ],
  pierce: [
    { e: 'pierce', at: 'SP2', polygon: 'A', other: 'B', normal: ['1/8', '0/1'], point: [9, 5] },
  ],
  split: [{ e: 'split', at: 'SP3', polygon: 'A', region: square, other: square }],
  facets: [
    { e: 'facets', at: 'WA2', pieces: [] },
    { e: 'facets', at: 'WA2', pieces: [['A', square, false]] },
  ],
  greatest_depth: [{ e: 'greatest_depth', at: 'DS1', polygon: 'A', z: '1/4' }],
  sorted: [
    { e: 'sorted', at: 'WA3', polygons: [] },
    { e: 'sorted', at: 'WA3', polygons: ['B', 'A'] },
  ],
  push_list: (['WA3', 'WA6', 'WA9'] as const).map((at) => ({
    e: 'push_list',
    at,
    pieces: [
      ['B', ring, false],
      ['A', square, true],
    ],
  })),
  pop_list: [{ e: 'pop_list', at: 'WA4', clip: 'B', count: 2 }],
  beside: [{ e: 'beside', at: 'WA5', polygon: 'A' }],
  clipped: [
    { e: 'clipped', at: 'WA5', polygon: 'A', clip: 'B', inside: square, outside: ring },
    { e: 'clipped', at: 'WA5', polygon: 'A', clip: 'B', inside: ring, outside: [] },
    { e: 'clipped', at: 'WA5', polygon: 'A', clip: 'B', inside: [], outside: square },
    { e: 'clipped', at: 'SP1', polygon: 'A', clip: 'B', inside: square, outside: ring },
  ],
  edge_piece: (['inside', 'outside', 'same_side', 'other_side'] as const).map((lies) => ({
    e: 'edge_piece',
    at: 'RC2',
    from: [0, 0],
    to: ['1/2', 4],
    lies,
  })),
  entering: [{ e: 'entering', at: 'RC3', point: ['1/2', 4] }],
  leaving: [{ e: 'leaving', at: 'RC3', point: [0.5, 4] }],
  behind: (
    [
      [-1, true],
      [0, true],
      [0, false],
      [1, false],
    ] as const
  ).map(([order, behind]) => ({
    e: 'behind',
    at: 'RB3',
    polygon: 'A',
    clip: 'B',
    point: [2, '3/2'],
    z: 0.5 + 0.25 * order,
    clipZ: 0.5,
    order,
    behind,
    exact: order,
    by: 'operands',
  })),
  nearer_ones: [
    { e: 'nearer_ones', at: 'WA7', polygons: [] },
    { e: 'nearer_ones', at: 'WA7', polygons: ['A'] },
  ],
  show: [{ e: 'show', at: 'WA8', polygon: 'B', region: ring }],
  order: ([-1, 0, 1] as const).map((order) => ({
    e: 'order',
    at: order === 1 ? 'PR2' : 'PR3',
    polygon: 'A',
    other: 'B',
    point: [0.5, 0.5],
    z: 0.5 + 0.25 * order,
    otherZ: 0.5,
    order,
  })),
  paint: [
    { e: 'paint', at: 'PR3', polygon: 'A', color: '#112233', runs: [] },
    { e: 'paint', at: 'PR3', polygon: 'A', color: '#112233', runs: [[0, 1, 2]] },
    {
      e: 'paint',
      at: 'PR3',
      polygon: 'A',
      color: '#112233',
      runs: [
        [0, 0, 3],
        [1, 0, 2],
      ],
    },
  ],
  painted: [{ e: 'painted', at: 'WA10' }],
};
