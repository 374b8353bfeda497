import type { FloatingHorizon } from '../curves/state.js';
import type { Regions } from '../regions/state.js';
import { eventNames, eventsOf, methods } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import { methodKindOf } from '../trace/method-kind.js';
import type { MethodKind } from '../trace/method-kind.js';
import type { Warnock } from './warnock.js';
import type { ZBuffer } from './zbuffer.js';

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
  /** It cannot always happen, and this decides besides its own values; else it can. */
  readonly needs?: readonly Field[];
}

const ofWindow: readonly Field[] = ['corners', 'k', 'count', 'hasSurround', 'color', 'insider'];
/** The state's copy of some of these, which outlives the window, or the polygon. */
const kept: readonly Field[] = ['last'];

/** A list of active polygons may be that of windows on the stack too. */
const list: Use = { changes: ['apl', 'stack'], needs: ['apl'] };
const joining: Use = { changes: ['apl', 'stack', 'joined'], needs: ['apl', 'joined'] };
const vertex: Use = { changes: ['clip'], needs: ['clip'] };
const painting: Use = { changes: ['picture'], needs: [] };
const none: Use = {};

export const uses: Readonly<Record<EventName, Use>> = {
  plane: none,
  call: none,
  depth: { changes: ['depths'] },
  fault: none,
  disagree: none,

  push: { changes: ['stack', 'root', 'division'], reads: ['apl'], needs: ['apl'] },
  skip: none,
  pop: {
    changes: ['stack', 'way'],
    sets: ['window', 'apl', 'nearest', 'covering', ...ofWindow],
    reads: ['window'],
    needs: ['stack'],
  },
  corners: { sets: [...ofWindow, 'covering', 'depths', 'last'] },
  box: none,
  discard: list,
  count: { sets: ['count', 'depths'], changes: kept },
  compare: none,
  nearer: {
    changes: ['corners', ...kept],
    sets: ['k'],
    reads: ['depths'],
    needs: ['corners', 'depths'],
  },
  uncover: { sets: ['hasSurround', 'covering'], changes: kept },
  surround: none,
  mark: list,
  cover: { sets: ['hasSurround', 'covering', 'color'], changes: kept },
  insider: { sets: ['insider'], changes: kept },
  summary: { sets: ['count', 'hasSurround', 'color', 'insider'], changes: kept },
  decide: none,
  fill: painting,
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
  draw: painting,

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
  ael_add: { changes: ['ael'], needs: ['ael'] },
  horizontal: none,
  leave: { changes: ['edges', ...kept], sets: ['nextS'], needs: ['edges'] },
  ael_sort: { changes: ['ael', ...kept], sets: ['nextAel'], needs: ['ael'] },
  line: none,
  miss: none,
  slope: none,
  columns: none,
  pixel: none,
  span: { changes: ['picture', 'z'], reads: ['polygon'], needs: ['polygon'] },
  ael_drop: { changes: ['ael', ...kept], sets: ['nextAel'], needs: ['ael'] },
  ael_step: { changes: ['ael'], needs: ['ael'] },

  horizons: { sets: ['horizons'] },
  curve: { sets: ['curve', 'place', 'told', 'flags', 'before'], reads: ['horizons'], needs: [] },
  side_edge: { changes: ['edges'] },
  visibility: { changes: ['place', 'flags', 'before'], reads: ['horizons'], needs: [] },
  intersection: none,
  draw_line: { changes: ['place'], reads: ['curve'], needs: ['curve'] },
  horizon: { changes: ['horizons'], needs: [] },
  height: { sets: ['told'] },
  raise: { changes: ['horizons'], needs: [] },
  lower: { changes: ['horizons'], needs: [] },
  step: none,

  cut_to_area: { changes: ['facets'], sets: ['crossings'] },
  pierce: { sets: ['piercing'] },
  split: none,
  facets: { sets: ['facets', 'piercing'] },
  greatest_depth: none,
  sorted: none,
  push_list: { changes: ['lists'] },
  pop_list: { changes: ['lists'], sets: ['inHand'], needs: ['lists'] },
  beside: { changes: ['inHand'], needs: ['inHand'] },
  clipped: { changes: ['inHand'], sets: ['piercing', 'crossings'], needs: ['inHand'] },
  edge_piece: none,
  entering: { changes: ['crossings'] },
  leaving: { changes: ['crossings'] },
  behind: { changes: ['inHand'], needs: ['inHand'] },
  nearer_ones: { changes: ['inHand'], needs: ['inHand'] },
  show: { changes: ['visible'] },
  order: none,
  paint: painting,
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

/** For each number whether the event may be impossible, or decides in any way whether a later one is possible. */
export const decisive: readonly boolean[] = decisiveNames();

function decisiveNames(): readonly boolean[] {
  const wanted = new Set(eventNames.flatMap((name) => uses[name].needs ?? []));
  const writes = ({ sets = [], changes = [] }: Use): boolean =>
    [...sets, ...changes].some((field) => wanted.has(field));
  for (let before = -1; before !== wanted.size;) {
    before = wanted.size;
    const read = Object.values(uses).filter(writes);
    for (const field of read.flatMap(({ reads = [] }) => reads)) wanted.add(field);
  }
  return eventNames.map((name) => uses[name].needs !== undefined || writes(uses[name]));
}
