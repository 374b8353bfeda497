import { callsFrom, eventsOf, kinds as table } from './event-table.js';
import type { Events } from './event-table.js';

/** The events of `vidno-trace/1`. Their types are derived from the program's table in trace/format/event.h. */

export { isFamily } from './editions.js';
export { callsFrom, corners, eventsOf } from './event-table.js';
export type { Decision, Events } from './event-table.js';

export const details = ['windows', 'polygons', 'signs'] as const;
export type Detail = (typeof details)[number];
export type Procedure = keyof typeof callsFrom;

/** The properties of an event name. */
export interface AnyKind {
  /** The lines of the listing that have it; null for any line. */
  readonly at: readonly string[] | null;
  /** The lowest level that includes it. */
  readonly from: Detail;
  readonly fields: readonly string[];
  /** The fields with numbers of the run's kernel. */
  readonly numbers: readonly string[];
  /** The call that it ends. */
  readonly resultOf?: Procedure;
}

export type EventName = keyof Events;
/** Any event, or the events with a name. */
export type Event<K extends EventName = EventName> = { readonly [P in K]: Events[P] }[K];

export type Method = keyof typeof eventsOf;
export const methods = Object.keys(eventsOf) as readonly Method[];
/** The variants of Warnock's algorithm. */
export type Variant = Extract<Method, `warnock-${string}`>;

type EventOf<M extends Method> = (typeof eventsOf)[M][number];
type Windows = 'warnock' | Variant;
type Common = EventOf<'zbuffer'> & EventOf<'weiler-atherton'>;
export type CommonEvents = Pick<Events, Common>;
/** The events of a method's runs, besides the common ones. */
export type EventsOf<M extends Method> = Pick<Events, Exclude<EventOf<M>, Common>>;
export type WarnockEvents = EventsOf<Windows>;
export type ZBufferEvents = EventsOf<'zbuffer'>;
export type FloatingHorizonEvents = EventsOf<'floating-horizon'>;
export type WeilerAthertonEvents = EventsOf<'weiler-atherton'>;
/** The events that only the variants of `warnock` have. */
export type FamilyEvents = Omit<WarnockEvents, EventOf<'warnock'>>;

export const kinds: Readonly<Record<EventName, AnyKind>> = table;

/** Whether runs of a method have such events. */
export const tells = (method: Method, name: EventName): boolean =>
  (eventsOf[method] as readonly EventName[]).includes(name);

/** Whether the event may occur at any line of a run. */
export const isOfAnyLine = (name: EventName): boolean => kinds[name].at === null;

/** Whether it goes from window to window. */
export const hasWindows = (method: Method): boolean => tells(method, 'pop');
/** Whether its scenes have curves and not polygons. */
export const drawsCurves = (method: Method): boolean => tells(method, 'curve');
/** Whether it has three lists of polygons: besides the usual one, those of surrounding and of outside polygons. */
export const hasThreeLists = (method: Method): boolean => tells(method, 'join');

/** The change in call depth of each event, by the number of its name. At a level without calls a result ends nothing. */
export function depthChanges(detail: Detail): readonly number[] {
  return eventNames.map((name) => {
    const { resultOf } = kinds[name];
    if (name === 'call') return 1;
    if (resultOf === undefined) return 0;
    return details.indexOf(detail) >= details.indexOf(callsFrom[resultOf]) ? -1 : 0;
  });
}

/** The event names by their numbers: passes over numbers are faster than over events. */
export const eventNames = Object.keys(kinds) as readonly EventName[];

export const numberOf: ReadonlyMap<EventName, number> = new Map(
  eventNames.map((name, i) => [name, i]),
);
