import type { Event, EventName } from '../trace/events.js';
import { floatingHorizonSamples } from './floating-horizon-samples.js';
import { weilerAthertonSamples } from './weiler-atherton-samples.js';

/** One event of each kind, and several where a sentence has cases. A missing kind does not compile. */
export const samples: { readonly [K in EventName]: readonly Event<K>[] } = {
  plane: [{ e: 'plane', at: 'I1', polygon: 'A', plane: [0, '1/3', -2.5, 'nan'] }],
  call: [{ e: 'call', at: 'PW8', of: 'SurroundTest' }],
  depth: [
    { e: 'depth', at: 'PW5', polygon: 'A', point: [0, 0], z: 0.25 },
    { e: 'depth', at: 'PC3', polygon: 'A', point: ['1/2', '1/2'], z: '1/10' },
  ],
  fault: [
    { e: 'fault', at: 'L6', reason: 'a write outside the area', x: 16, y: 3 },
    { e: 'fault', at: 'S2', reason: 'the list of edges ends' },
    { e: 'fault', at: 'RC4', reason: 'an outline is open' },
  ],
  disagree: [
    { e: 'disagree', at: 'S3', of: 'orientation', taken: -1, exact: 0, cause: 'rounded' },
    { e: 'disagree', at: 'L6', of: 'nearer', taken: true, exact: false, cause: 'drifted' },
    { e: 'disagree', at: 'F2', of: 'columns', taken: [8, 8], exact: [7, 9], cause: 'drifted' },
    { e: 'disagree', at: 'F2', of: 'columns', taken: [7, 9], exact: [7, 8], cause: 'drifted' },
  ],
  push: [
    { e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [['A', false]] },
    { e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [] },
    { e: 'push', at: 'W13', window: [4, 0, 4, 4] },
    { e: 'push', at: 'W13', window: [4, 0, 4, 4], shared: true },
    { e: 'push', at: 'WF1', window: [0, 0, 8, 8], apl: [['A', false]] },
    { e: 'push', at: 'WF12', window: [4, 0, 4, 4], shared: true },
  ],
  skip: [{ e: 'skip', at: 'W13', window: [4, 0, 4, 4] }],
  pop: [
    { e: 'pop', at: 'W5', window: [4, 0, 4, 4] },
    { e: 'pop', at: 'WF2', window: [4, 0, 4, 4] },
  ],
  corners: [{ e: 'corners', at: 'PW1', z: '-inf' }],
  box: [
    {
      e: 'box',
      at: 'PW3',
      polygon: 'A',
      box: [0, 0, 3, 3],
      outside: true,
      exact: null,
      by: 'given',
    },
    { e: 'box', at: 'PW3', polygon: 'A', box: [0, 0, 3, 3], outside: false },
  ],
  discard: [{ e: 'discard', at: 'PW3', polygon: 'A' }],
  count: [{ e: 'count', at: 'PW4', polygon: 'A', count: 2 }],
  compare: [
    { e: 'compare', at: 'PW6', polygon: 'A', corner: 'lt', z: 0.5, against: '-inf', nearer: true },
    { e: 'compare', at: 'PC4', polygon: 'A', z: 0.5, against: 0.5, nearer: false },
  ],
  nearer: [
    { e: 'nearer', at: 'PW6', polygon: 'A', corners: [], k: 0 },
    { e: 'nearer', at: 'PW6', polygon: 'A', corners: ['lb', 'lt'], k: 2 },
    { e: 'nearer', at: 'PW6', polygon: 'A', corners: ['lb', 'lt', 'rb', 'rt'], k: 4 },
  ],
  uncover: [{ e: 'uncover', at: 'PW7', polygon: 'A' }],
  surround: [
    { e: 'surround', at: 'PW8', polygon: 'A', point: [0, 0], inside: true },
    { e: 'surround', at: 'PC2', polygon: 'A', point: [0.5, 0.5], inside: false },
  ],
  mark: [{ e: 'mark', at: 'PW8', polygon: 'A' }],
  cover: [{ e: 'cover', at: 'PW9', polygon: 'A', color: '#112233' }],
  insider: [
    { e: 'insider', at: 'PW10', polygon: 'A', inside: true },
    { e: 'insider', at: 'PW10', polygon: 'A', inside: false },
    { e: 'insider', at: 'RE2', polygon: 'A', inside: false },
  ],
  summary: [
    { e: 'summary', at: 'W6', count: 1, hasSurround: true, color: '#112233', insider: false },
    { e: 'summary', at: 'W6', count: 3, hasSurround: false, insider: false },
  ],
  decide: (['empty', 'surrounded', 'pixel', 'single', 'split'] as const).map((which) => ({
    e: 'decide',
    at: 'W7',
    case: which,
  })),
  fill: [
    { e: 'fill', at: 'W7', rect: [0, 0, 4, 4], color: '#ffffff' },
    { e: 'fill', at: 'W8', rect: [0, 0, 1, 1], color: '#112233' },
  ],
  nearest: [{ e: 'nearest', at: 'PC4', polygon: 'A', z: 0.1, color: '#112233' }],
  color: [{ e: 'color', at: 'W9', point: [0.5, 0.5], color: '#ffffff' }],
  orient: (['S3', 'TF2', 'CR4', 'OA4', 'ED3', 'BF1'] as const).flatMap((at) =>
    ([-1, 0, 1] as const).map((sign) => ({
      e: 'orient',
      at,
      polygon: 'A',
      edge: 2,
      point: [0, 0],
      value: sign,
      sign,
    })),
  ),
  clip_begin: [{ e: 'clip_begin', at: 'PL1', polygon: 'A', window: [0, 0, 4, 4] }],
  clip_side: [{ e: 'clip_side', at: 'PL2', side: 1, from: [4, 0], to: [0, 0] }],
  clip_sign: ([-1, 0, 1] as const).map((sign) => ({
    e: 'clip_sign',
    at: 'PL4',
    vertex: [1, 2, 0.5],
    value: sign,
    sign,
  })),
  clip_cross: [{ e: 'clip_cross', at: 'PL5', vertex: [1, 2, 0.5] }],
  clip_keep: [{ e: 'clip_keep', at: 'PL6', vertex: [1, 2, 0.5] }],
  clip_drop: [{ e: 'clip_drop', at: 'PL6', vertex: [1, 2, 0.5] }],
  clip_list: [
    { e: 'clip_list', at: 'PL7', count: 0 },
    { e: 'clip_list', at: 'PL7', count: 5 },
  ],
  clip_result: [
    { e: 'clip_result', at: 'W12', polygon: 'A', vertices: [] },
    { e: 'clip_result', at: 'W12', polygon: 'A', vertices: [[1, 2, 0.5]] },
  ],
  row: [
    { e: 'row', at: 'F2', row: 3, left: 1.25, right: 4, first: 1, end: 4, exact: [1, 4] },
    { e: 'row', at: 'F2', row: 3, left: 1.25, right: 1.3, first: 1, end: 1 },
  ],
  draw: [{ e: 'draw', at: 'W12', polygon: 'A', color: '#112233', runs: [[0, 1, 3]] }],
  back_face: [
    { e: 'back_face', at: 'BF2', polygon: 'A', away: true },
    { e: 'back_face', at: 'BF2', polygon: 'A', away: false },
  ],
  rejoin: [{ e: 'rejoin', at: 'WF3', polygon: 'A', list: 'surrounding', level: 2 }],
  join: [{ e: 'join', at: 'WF4', polygon: 'A', list: 'outside', level: 0 }],
  relation: (['outside', 'inside', 'intersecting', 'surrounding'] as const).map((relation) => ({
    e: 'relation',
    at: 'WF4',
    polygon: 'A',
    relation,
  })),
  trial: [
    { e: 'trial', at: 'TF3', polygon: 'A', edge: 0, meets: true },
    { e: 'trial', at: 'TF3', polygon: 'A', edge: 0, meets: false },
  ],
  meets: [
    { e: 'meets', at: 'RE3', polygon: 'A', meets: true },
    { e: 'meets', at: 'RE3', polygon: 'A', meets: false },
  ],
  ray: [
    ...([0, 1, 2] as const).map((counts) => ({
      e: 'ray' as const,
      at: 'CR3' as const,
      polygon: 'A',
      edge: 1,
      counts,
    })),
    { e: 'ray', at: 'CR4', polygon: 'A', edge: 1, counts: 0 },
    { e: 'ray', at: 'CR4', polygon: 'A', edge: 1, counts: 1 },
  ],
  crossings: [
    { e: 'crossings', at: 'RE4', polygon: 'A', count: 1 },
    { e: 'crossings', at: 'RE4', polygon: 'A', count: 2 },
  ],
  octants: [
    { e: 'octants', at: 'OA3', polygon: 'A', edge: 1, from: 0, to: 6, difference: -2 },
    { e: 'octants', at: 'OA4', polygon: 'A', edge: 1, from: 2, to: 6, difference: 4 },
  ],
  angle: [
    { e: 'angle', at: 'RE4', polygon: 'A', octants: -8 },
    { e: 'angle', at: 'RE4', polygon: 'A', octants: 0 },
  ],
  hiding: [
    { e: 'hiding', at: 'WF10', polygon: 'A' },
    { e: 'hiding', at: 'WF10' },
  ],
  split_vertex: [
    { e: 'split_vertex', at: 'VS2', polygon: 'A', vertex: 1, column: 3, row: 2, splits: true },
    { e: 'split_vertex', at: 'VS2', polygon: 'A', vertex: 1, column: 4, row: 0, splits: false },
  ],
  edge_depth: [{ e: 'edge_depth', at: 'ED5', polygon: 'A', edge: 0, z: '1/3' }],
  clear: [{ e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' }],
  polygon: [{ e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' }],
  edge: [
    { e: 'edge', at: 'Z3', edge: 0, from: [0, 0, 0.5], to: [4, 4, 0.5] },
    { e: 'edge', at: 'Z3', edge: 0, from: [0, 0, 0.5], to: [4, 4, 0.5], rows: [0, 3] },
    { e: 'edge', at: 'Z3', edge: 0, from: [0, 0, 0.5], to: [4, 0, 0.5], rows: [0, -1] },
  ],
  extent: [{ e: 'extent', at: 'Z4', ymin: 0, ymax: 4 }],
  scanline: [{ e: 'scanline', at: 'Z6', y: 2.5, row: 2 }],
  ael_add: [{ e: 'ael_add', at: 'Z8', edge: 0, x: 0.5, z: 0.5, until: 3, dx: 1, dz: 0 }],
  horizontal: [{ e: 'horizontal', at: 'Z9', edge: 0 }],
  leave: [
    { e: 'leave', at: 'Z10', edges: [], next: 5 },
    { e: 'leave', at: 'Z10', edges: [1], next: 'inf' },
    { e: 'leave', at: 'Z10', edges: [1, 2], next: '7/1' },
  ],
  ael_sort: [
    { e: 'ael_sort', at: 'Z12', edges: [], next: 'inf' },
    { e: 'ael_sort', at: 'Z12', edges: [2, 1], next: 4 },
  ],
  line: [{ e: 'line', at: 'L1', row: 2, from: [0.5, 0.1], to: [3.5, 0.2] }],
  miss: [{ e: 'miss', at: 'L2' }],
  slope: [
    { e: 'slope', at: 'L3', dz: 0.01 },
    { e: 'slope', at: 'L3', dz: 'nan' },
  ],
  columns: [
    { e: 'columns', at: 'L4', first: 0, end: 4, z: 0.1 },
    { e: 'columns', at: 'L4', first: 1, end: 1, z: 0.1 },
  ],
  pixel: [
    { e: 'pixel', at: 'L6', x: 1, y: 2, z: 0.5, stored: '-inf', shown: true },
    { e: 'pixel', at: 'L6', x: 1, y: 2, z: 0.5, stored: 0.5, shown: false },
  ],
  span: [
    { e: 'span', at: 'Z14', row: 2, runs: [[1, 4]], depths: [0.1, 0.2, 0.3] },
    { e: 'span', at: 'Z9', row: 2, runs: [] },
  ],
  ael_drop: [
    { e: 'ael_drop', at: 'Z16', edges: [], next: 5 },
    { e: 'ael_drop', at: 'Z16', edges: [0], next: 'inf' },
  ],
  ael_step: [{ e: 'ael_step', at: 'Z17', edge: 0, x: 1.5, z: 0.5 }],

  ...floatingHorizonSamples,
  ...weilerAthertonSamples,
};

export const allSamples: readonly Event[] = Object.values(samples).flat();
