import type { Checked, Fields, Check, Recorded } from './check.js';
import { callsFrom, eventsOf, kinds as table } from './event-table.js';
import type { decisions } from './event-table.js';

/**
 * The events of `vidno-trace/1`: their types and the check of a line follow from one table, which the build makes of the
 * program's, trace/format/event.h.
 */

export { isFamily } from './editions.js';
export { callsFrom, corners, eventsOf } from './event-table.js';

export const details = ['windows', 'polygons', 'signs'] as const;
export type Detail = (typeof details)[number];
export type Procedure = keyof typeof callsFrom;
export type Decision = (typeof decisions)[number];

/**
 * What there is to say of the events of a name: the lines that tell them, the level from which, their fields, the call that
 * they end, and what they decide.
 */
export interface AnyKind {
  readonly at: Check<string>;
  readonly from: Detail;
  readonly fields: Fields;
  readonly resultOf?: Procedure;
  readonly decides?: Decision;
}

type Kinds = typeof table;
export type EventName = keyof Kinds;
export type Events = {
  readonly [K in EventName]: { readonly e: K; readonly at: Checked<Kinds[K]['at']> } & Recorded<
    Kinds[K]['fields']
  >;
};
/** An event, or with a name the event of that name. */
export type Event<K extends EventName = EventName> = { readonly [P in K]: Events[P] }[K];

/** Those that tell a decision. */
export type Deciding = {
  [K in EventName]: Kinds[K] extends { readonly decides: Decision } ? K : never;
}[EventName];

export type Method = keyof typeof eventsOf;
export const methods = Object.keys(eventsOf) as readonly Method[];

type EventOf<M extends Method> = (typeof eventsOf)[M][number];
type Windows = Exclude<Method, 'zbuffer' | 'weiler-atherton' | 'floating-horizon'>;
type Common = EventOf<'zbuffer'> & EventOf<'weiler-atherton'>;
export type CommonEvents = Pick<Events, Common>;
export type WarnockEvents = Pick<Events, Exclude<EventOf<Windows>, Common>>;
export type ZBufferEvents = Pick<Events, Exclude<EventOf<'zbuffer'>, Common>>;
export type CurveEvents = Pick<Events, Exclude<EventOf<'floating-horizon'>, Common>>;
export type RegionEvents = Pick<Events, Exclude<EventOf<'weiler-atherton'>, Common>>;
/** What `warnock` itself does not tell. */
export type FamilyEvents = Omit<WarnockEvents, EventOf<'warnock'>>;

export const kinds: Readonly<Record<EventName, AnyKind>> &
  Readonly<Record<Deciding, { readonly decides: Decision }>> = table;

/** Whether runs of a method tell such events. */
export const tells = (method: Method, name: EventName): boolean =>
  (eventsOf[method] as readonly EventName[]).includes(name);

/** Whether any line of a run may tell them. */
export const isToldAnywhere = (name: EventName): boolean => kinds[name].at === kinds.call.at;

/** Whether it goes from window to window. */
export const hasWindows = (method: Method): boolean => tells(method, 'pop');
/** Whether its scenes are curves, not polygons. */
export const drawsCurves = (method: Method): boolean => tells(method, 'curve');
/** Whether the list of polygons is the third of three, of which the others hold what surrounds or is outside. */
export const hasThreeLists = (method: Method): boolean => tells(method, 'join');

/** The names, each at its number: numbers are looked through faster than events. */
export const eventNames = Object.keys(kinds) as readonly EventName[];

export const numberOf: ReadonlyMap<EventName, number> = new Map(
  eventNames.map((name, i) => [name, i]),
);
