import { floatingHorizon } from '../curves/events.js';
import { weilerAtherton } from '../regions/events.js';
import {
  between,
  bool,
  count,
  list,
  matching,
  oneOf,
  optional,
  text,
  tuple,
  whole,
} from './check.js';
import type { Checked, Recorded } from './check.js';
import { decisions, told } from './decisions.js';
import { bodies, lists } from './family-events.js';
import { kind } from './kind.js';
import type { AnyKind } from './kind.js';
import { row } from './row-event.js';
import { zbuffer } from './zbuffer-events.js';
import { answer, box, color, corner, id, num, pair, pixels, runs, sign, triple } from './values.js';

/**
 * The events of `vidno-trace/1` as one table: the types of the events and the check of a line are both
 * derived from it, so that they cannot part. The order of events and fields is that of FORMAT.md.
 */

export { decisions, told } from './decisions.js';
export type { Decision } from './decisions.js';
export { details } from './kind.js';
export type { AnyKind, Detail } from './kind.js';

const anyLine = matching(
  /^(?:W|PW|PC|D|S|PL|I|F|Z|L|WS|WF|RE|TF|CR|OA|HP|VS|ED|BF|FH|SE|V|H|IN|WA|SP|DS|RC|RB|PR)[1-9]\d?$/,
  'label',
);

export const procedures = [
  'ProcessWindow',
  'PointColor',
  'SurroundTest',
  'PolygonClip',
  'FillPolygon',
  'ShowLine',
  'Relation',
  'TrialFunction',
  'RayCrossings',
  'OctantAngles',
  'HidingPolygon',
  'SideEdge',
  'Visibility',
  'Horizon',
  'Intersection',
  'SplitPiercing',
  'DepthSort',
  'RegionClip',
  'RemoveBehind',
  'PaintRegions',
] as const;
export type Procedure = (typeof procedures)[number];

export const common = {
  plane: kind(oneOf('I1'), 'p', { polygon: id, plane: tuple(num, num, num, num) }),
  call: kind(anyLine, 'p', { of: oneOf(...procedures) }),
  depth: kind(oneOf('PW5', 'PC3', 'Z3', 'HP3', 'DS1', 'RB2'), 'p', {
    polygon: id,
    point: pair,
    z: num,
  }),
  fault: kind(anyLine, 'w', { reason: text, x: optional(whole), y: optional(whole) }),
  disagree: kind(anyLine, 'w', {
    of: oneOf(...decisions),
    taken: answer,
    exact: answer,
    cause: oneOf('rounded', 'drifted'),
  }),
} as const;

/** Where a window gets one colour, which of it may be a polygon's surroundings only; and where it is split. */
const filling = [
  ...(['W7', 'W8', 'W9', 'W10'] as const),
  ...(['WS4', 'WS5'] as const),
  ...(['WF5', 'WF6', 'WF9', 'WF10', 'WF11'] as const),
] as const;
const deciding = [...filling, 'W13', 'WS6', 'WF12'] as const;

export const warnock = {
  push: kind(oneOf('W3', 'W13', 'WS1', 'WS6', 'WF1', 'WF12'), 'w', {
    window: box,
    apl: optional(list(tuple(id, bool))),
    shared: optional(oneOf(true)),
  }),
  skip: kind(oneOf('W13', 'WS6', 'WF12'), 'w', { window: box }),
  pop: kind(oneOf('W5', 'WS2', 'WF2'), 'w', { window: box }),
  corners: kind(oneOf('PW1', 'HP1'), 'p', { z: num }),
  box: kind(oneOf('PW3', 'WS3', 'RE1'), 's', {
    polygon: id,
    box: tuple(num, num, num, num),
    outside: bool,
    ...told,
  }),
  discard: kind(oneOf('PW3', 'WS3'), 'p', { polygon: id }),
  count: kind(oneOf('PW4'), 'p', { polygon: id, count }),
  compare: kind(oneOf('PW6', 'PC4', 'HP4'), 's', {
    polygon: id,
    corner: optional(corner),
    z: num,
    against: num,
    nearer: bool,
    ...told,
  }),
  nearer: kind(oneOf('PW6', 'HP4'), 'p', { polygon: id, corners: list(corner), k: between(0, 4) }),
  uncover: kind(oneOf('PW7', 'HP5'), 'p', { polygon: id }),
  surround: kind(oneOf('PW8', 'PC2'), 'p', { polygon: id, point: pair, inside: bool }),
  mark: kind(oneOf('PW8'), 'p', { polygon: id }),
  cover: kind(oneOf('PW9', 'HP6'), 'p', { polygon: id, color }),
  insider: kind(oneOf('PW10', 'RE2'), 'p', { polygon: id, inside: bool, ...told }),
  summary: kind(oneOf('W6'), 'p', {
    count,
    hasSurround: bool,
    color: optional(color),
    insider: bool,
  }),
  decide: kind(oneOf(...deciding), 'w', {
    case: oneOf('empty', 'surrounded', 'pixel', 'single', 'split'),
  }),
  fill: kind(oneOf(...filling), 'w', { rect: pixels, color }),
  nearest: kind(oneOf('PC4'), 'p', { polygon: id, z: num, color }),
  color: kind(oneOf('W9', 'WS5', 'WF11'), 'p', { point: pair, color }),
  orient: kind(oneOf('S2', 'S3', 'TF2', 'CR4', 'OA4', 'ED3', 'BF1'), 's', {
    polygon: id,
    edge: count,
    point: pair,
    value: num,
    sign,
    ...told,
  }),
  clip_begin: kind(oneOf('PL1'), 'p', { polygon: id, window: box }),
  clip_side: kind(oneOf('PL2'), 'p', { side: between(1, 4), from: pair, to: pair }),
  clip_sign: kind(oneOf('PL3', 'PL4'), 's', { vertex: triple, value: num, sign, ...told }),
  clip_cross: kind(oneOf('PL5'), 'p', { vertex: triple }),
  clip_keep: kind(oneOf('PL6'), 'p', { vertex: triple }),
  clip_drop: kind(oneOf('PL6'), 'p', { vertex: triple }),
  clip_list: kind(oneOf('PL7'), 'p', { count }),
  clip_result: kind(oneOf('W12', 'WF8'), 'p', { polygon: id, vertices: list(triple) }),
  row,
  draw: kind(oneOf('W11', 'W12', 'WF7', 'WF8'), 'w', { polygon: id, color, runs }),
} as const;

const threeLists = { ...warnock, ...lists } as const;

export const tables = {
  warnock,
  'warnock-simplest': warnock,
  'warnock-full': threeLists,
  'warnock-angles': threeLists,
  'warnock-vertex': threeLists,
  'warnock-edges': threeLists,
  'warnock-bodies': { ...warnock, ...bodies },
  zbuffer,
  'floating-horizon': floatingHorizon,
  'weiler-atherton': weilerAtherton,
} as const;
export type Method = keyof typeof tables;
export const methods = Object.keys(tables) as readonly Method[];

/** Whether it goes from window to window. */
export const hasWindows = (method: Method): boolean => 'pop' in tables[method];
/** Whether the list of polygons is the third of three, of which the others hold what surrounds or is outside. */
export const hasThreeLists = (method: Method): boolean => 'join' in tables[method];
/** A variant of Warnock's algorithm: its text is the corrected one. */
export const isFamily = (method: Method): boolean => method.startsWith('warnock-');

type EventsOf<T extends Readonly<Record<string, AnyKind>>> = {
  readonly [K in keyof T]: { readonly e: K; readonly at: Checked<T[K]['at']> } & Recorded<
    T[K]['fields']
  >;
};

export type CommonEvents = EventsOf<typeof common>;
export type WarnockEvents = EventsOf<typeof threeLists> & EventsOf<typeof bodies>;
export type ZBufferEvents = EventsOf<typeof zbuffer>;
export type CurveEvents = EventsOf<typeof floatingHorizon>;
export type RegionEvents = EventsOf<typeof weilerAtherton>;
export type Events = CommonEvents & WarnockEvents & ZBufferEvents & CurveEvents & RegionEvents;

export type EventName = keyof Events;
/** An event, or with a name the event of that name. */
export type Event<K extends EventName = EventName> = { readonly [P in K]: Events[P] }[K];

/** Those of all methods. */
export const kinds: Readonly<Record<EventName, AnyKind>> = {
  ...common,
  ...warnock,
  ...bodies,
  ...lists,
  ...zbuffer,
  ...floatingHorizon,
  ...weilerAtherton,
};

/** The names, each at its number: numbers are looked through faster than events. */
export const eventNames = Object.keys(kinds) as readonly EventName[];

export const numberOf: ReadonlyMap<EventName, number> = new Map(
  eventNames.map((name, i) => [name, i]),
);
