import type { FloatingHorizon } from '../floating-horizon/state.js';
import type { Regions } from '../weiler-atherton/state.js';
import { eventNames, eventsOf, methods } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import { methodKindOf } from '../trace/method-kind.js';
import type { MethodKind } from '../trace/method-kind.js';
import type { Warnock } from '../warnock/state.js';
import type { ZBuffer } from '../zbuffer/state.js';

/** A part of the state; the stack of calls and the lines that were drawn are followed apart. */
export type Field =
  | keyof Warnock
  | keyof ZBuffer
  | keyof FloatingHorizon
  | keyof Regions
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

const ofWindow: readonly Field[] = ['corners', 'k', 'count', 'hasSurround', 'color', 'insider'];
/** The state's copy of some of these, which outlives the window, or the polygon. */
const kept: readonly Field[] = ['last'];

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
    sets: ['window', 'apl', 'nearest', 'covering', ...ofWindow],
    reads: ['window'],
  },
  corners: { sets: [...ofWindow, 'covering', 'depths', 'last'] },
  box: none,
  discard: list,
  count: { sets: ['count', 'depths'], changes: kept },
  compare: none,
  nearer: { changes: ['corners', ...kept], sets: ['k'], reads: ['depths'] },
  uncover: { sets: ['hasSurround', 'covering'], changes: kept },
  surround: none,
  mark: list,
  cover: { sets: ['hasSurround', 'covering', 'color'], changes: kept },
  insider: { sets: ['insider'], changes: kept },
  summary: { sets: ['count', 'hasSurround', 'color', 'insider'], changes: kept },
  decide: none,
  fill: { changes: ['picture'] },
  nearest: { sets: ['nearest'] },
  color: { sets: ['color'], changes: kept },
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
  hiding: { sets: ['hasSurround', 'covering'], changes: kept },
  split_vertex: none,
  edge_depth: none,

  clear: { sets: ['picture', 'z'] },
  polygon: { sets: ['polygon', 'edges', 'ael', 'y', 'row', 'nextS', 'nextAel'] },
  edge: { changes: ['edges'] },
  extent: none,
  scanline: { sets: ['y', 'row'], changes: kept },
  ael_add: { changes: ['ael'] },
  horizontal: none,
  leave: { changes: ['edges', ...kept], sets: ['nextS'] },
  ael_sort: { changes: ['ael', ...kept], sets: ['nextAel'] },
  line: none,
  miss: none,
  slope: none,
  columns: none,
  pixel: none,
  span: { changes: ['picture', 'z'], reads: ['polygon'] },
  ael_drop: { changes: ['ael', ...kept], sets: ['nextAel'] },
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

  cut_to_area: { changes: ['facets'], sets: ['crossings'] },
  pierce: { sets: ['piercing'] },
  split: none,
  facets: { sets: ['facets', 'piercing'] },
  greatest_depth: none,
  sorted: none,
  push_list: { changes: ['lists'] },
  pop_list: { changes: ['lists'], sets: ['inHand'] },
  beside: { changes: ['inHand'] },
  clipped: { changes: ['inHand'], sets: ['piercing', 'crossings'] },
  edge_piece: none,
  entering: { changes: ['crossings'] },
  leaving: { changes: ['crossings'] },
  behind: { changes: ['inHand'] },
  nearer_ones: { changes: ['inHand'] },
  show: { changes: ['visible'] },
  order: none,
  paint: { changes: ['picture'] },
  painted: none,
};

/** Sets of fields as bits. */
type Fields = number;

export const fieldsOf = ({ sets = [], changes = [], reads = [] }: Use): readonly Field[] => [
  ...sets,
  ...changes,
  ...reads,
];
/** The fields of the runs of each kind. */
const byKind = new Map<MethodKind, Set<Field>>();
for (const method of methods) {
  const kind = methodKindOf(method);
  const known = byKind.get(kind) ?? [];
  byKind.set(
    kind,
    new Set([...known, ...eventsOf[method].flatMap((name) => fieldsOf(uses[name]))]),
  );
}
const ofKinds = [...byKind.values()];
const isShared = (field: Field): boolean => ofKinds.filter((own) => own.has(field)).length > 1;
const all = [...new Set(ofKinds.flatMap((own) => [...own]))];
const shared = all.filter(isShared);

/** There are more fields than bits: kinds of runs share the bits of the fields that no other kind has. */
const places = new Map(
  ofKinds.flatMap((own) =>
    [...shared, ...[...own].filter((field) => !isShared(field))].map((field, i) => [field, i]),
  ),
);
export const bits = (some: readonly Field[] = []): Fields =>
  some.reduce((found, field) => found | (1 << (places.get(field) ?? 0)), 0);

export const everything: Fields = bits(all);

/** For each number of an event's name the fields that it writes, sets, and needs to be right before it. */
export const written = eventNames.map((name) => bits(uses[name].sets) | bits(uses[name].changes));
export const set = eventNames.map((name) => bits(uses[name].sets));
export const needed = eventNames.map((name) => bits(uses[name].changes) | bits(uses[name].reads));
