import type { FloatingHorizon } from '../curves/state.js';
import { eventNames } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import type { Warnock } from './warnock.js';
import type { ZBuffer } from './zbuffer.js';

/** A part of the state; the stack of calls and the lines that were drawn are followed apart. */
export type Field =
  | keyof Warnock
  | keyof ZBuffer
  | keyof FloatingHorizon
  | 'picture'
  | 'division'
  | 'z'
  | 'horizons'
  | 'before'
  | 'flags';

/** What an event does with the state before it. */
export interface Use {
  /** Gets a new value, whatever the old one was. */
  readonly sets?: readonly Field[];
  /** Gets a value that depends on the old one. */
  readonly changes?: readonly Field[];
  /** Is looked at besides. */
  readonly reads?: readonly Field[];
}

const ofWindow: readonly Field[] = [
  'corners',
  'isTested',
  'k',
  'count',
  'hasSurround',
  'covering',
  'color',
  'insider',
  'depths',
];

/** A list of active polygons may be that of windows on the stack too. */
const list: Use = { changes: ['apl', 'stack'] };
const joining: Use = { changes: ['apl', 'stack', 'joined'] };
const vertex: Use = { changes: ['clip'] };
const none: Use = {};

export const uses: Readonly<Record<EventName, Use>> = {
  plane: none,
  call: none,
  depth: { changes: ['depths'] },
  fault: none,
  disagree: none,

  push: { changes: ['stack', 'root', 'division'], reads: ['apl'] },
  skip: none,
  pop: {
    changes: ['stack', 'way'],
    sets: ['window', 'apl', 'nearest', 'covering', 'isTested'],
    reads: ['window'],
  },
  corners: { sets: ofWindow },
  box: none,
  discard: list,
  count: { sets: ['count', 'depths'] },
  compare: none,
  nearer: { changes: ['corners'], sets: ['k'], reads: ['depths'] },
  uncover: { sets: ['hasSurround', 'covering'] },
  surround: none,
  mark: list,
  cover: { sets: ['hasSurround', 'covering', 'color'] },
  insider: { sets: ['insider'] },
  summary: { sets: ['count', 'hasSurround', 'color', 'insider'] },
  decide: none,
  fill: { changes: ['picture'] },
  nearest: { sets: ['nearest'] },
  color: { sets: ['color'] },
  orient: none,
  clip_begin: { sets: ['clip'] },
  clip_side: vertex,
  clip_sign: none,
  clip_cross: vertex,
  clip_keep: vertex,
  clip_drop: none,
  clip_list: vertex,
  clip_result: { sets: ['clip'] },
  row: none,
  draw: { changes: ['picture'] },

  back_face: none,
  rejoin: joining,
  join: joining,
  relation: { sets: ['contained'] },
  trial: none,
  meets: { sets: ['contained'] },
  ray: { changes: ['contained'] },
  crossings: none,
  octants: { changes: ['contained'] },
  angle: none,
  hiding: { sets: ['hasSurround', 'covering'] },
  split_vertex: none,
  edge_depth: none,

  clear: { sets: ['picture', 'z'] },
  polygon: { sets: ['polygon', 'edges', 'ael'] },
  edge: { changes: ['edges'] },
  extent: none,
  scanline: { sets: ['y', 'row'] },
  ael_add: { changes: ['ael'] },
  horizontal: none,
  leave: { changes: ['edges'], sets: ['nextS'] },
  ael_sort: { changes: ['ael'], sets: ['nextAel'] },
  line: none,
  miss: none,
  slope: none,
  columns: none,
  pixel: none,
  span: { changes: ['picture', 'z'], reads: ['polygon'] },
  ael_drop: { changes: ['ael'], sets: ['nextAel'] },
  ael_step: { changes: ['ael'] },

  horizons: { sets: ['horizons'] },
  curve: { sets: ['curve', 'place', 'told', 'flags', 'before'], reads: ['horizons'] },
  side_edge: { changes: ['edges'] },
  visibility: { changes: ['place', 'flags', 'before'], reads: ['horizons'] },
  intersection: none,
  draw_line: { changes: ['place'], reads: ['curve'] },
  horizon: { changes: ['horizons'] },
  height: { sets: ['told'] },
  raise: { changes: ['horizons'] },
  lower: { changes: ['horizons'] },
  step: none,
};

/** Sets of fields as bits. */
type Fields = number;

const fieldsOf = ({ sets = [], changes = [], reads = [] }: Use): readonly Field[] => [
  ...sets,
  ...changes,
  ...reads,
];
const fields = [...new Set(Object.values(uses).flatMap(fieldsOf))];
const bits = (some: readonly Field[] = []): Fields =>
  some.reduce((all, field) => all | (1 << fields.indexOf(field)), 0);

export const everything: Fields = bits(fields);

/** For each number of an event's name the fields that it writes, sets, and needs to be right before it. */
export const written = eventNames.map((name) => bits(uses[name].sets) | bits(uses[name].changes));
export const set = eventNames.map((name) => bits(uses[name].sets));
export const needed = eventNames.map((name) => bits(uses[name].changes) | bits(uses[name].reads));
