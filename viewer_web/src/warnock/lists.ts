import type { Screen } from '../replay/screen.js';
import type { Event, WarnockEvents } from '../trace/events.js';
import type { Scene } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Box } from '../trace/values.js';
import type { Apl, Entry, Warnock } from './state.js';

/** The windows that were divided on the way to the next one. */
export function wayTo(next: Box, { way, window }: Pick<Warnock, 'way' | 'window'>): readonly Box[] {
  return (window === null ? way : [...way, window]).filter((each) => holds(each, next));
}

const holds = ([x, y, width, height]: Box, [left, top, across, down]: Box): boolean =>
  x <= left && y <= top && left + across <= x + width && top + down <= y + height;

export function currentApl(now: Warnock): Apl {
  if (now.apl === null) throw new Refusal('', 'noWindow');
  return now.apl;
}

/** Replaces the current list, also in the windows that share it. */
export function changeApl(now: Warnock, entries: readonly Entry[]): Partial<Warnock> {
  const old = currentApl(now);
  const apl = { entries };
  const shared = now.stack.some((each) => each.apl === old);
  const stack = shared
    ? now.stack.map((each) => (each.apl === old ? { ...each, apl } : each))
    : now.stack;
  return { apl, stack };
}

function entryIndex(now: Warnock, polygon: string): number {
  const index = currentApl(now).entries.findIndex(([id]) => id === polygon);
  if (index < 0) throw new Refusal('polygon', 'notInList', polygon);
  return index;
}

/** Removes a polygon from the current list. */
function without(polygon: string, now: Warnock): Partial<Warnock> {
  const index = entryIndex(now, polygon);
  return changeApl(
    now,
    currentApl(now).entries.filter((_, i) => i !== index),
  );
}

/** Moves a polygon of the current list to the list of surrounding or of outside polygons. */
export function joinedBy(
  { polygon, list, level }: WarnockEvents['join'],
  now: Warnock,
): Partial<Warnock> {
  const joined = { ...now.joined, [list]: [...now.joined[list], { polygon, level }] };
  return { ...without(polygon, now), joined };
}

/** Moves the last of the surrounding or outside polygons back to its place in the current list. */
export function rejoined(
  { polygon, list }: WarnockEvents['rejoin'],
  now: Warnock,
  screen: Screen,
): Partial<Warnock> {
  const joined = now.joined[list];
  if (joined.at(-1)?.polygon !== polygon) throw new Refusal('polygon', 'notLast', polygon);
  const { entries } = currentApl(now);
  const before = entries.filter(([id]) => screen.placeOf(id) < screen.placeOf(polygon));
  const back: readonly Entry[] = [...before, [polygon, false], ...entries.slice(before.length)];
  return { ...changeApl(now, back), joined: { ...now.joined, [list]: joined.slice(0, -1) } };
}

/** Adds an edge to the count for containment. */
export function counted(
  event: Event<'ray'> | Event<'octants'>,
  { contained }: Warnock,
): Partial<Warnock> {
  return { contained: [...contained, event] };
}

/** Whether it is the first window that is pushed. */
export const isRoot = ({ at }: WarnockEvents['push']): boolean =>
  at === 'W3' || at === 'WS1' || at === 'WF1';

/** The list of a window that is pushed. */
export function pushedApl(event: WarnockEvents['push'], now: Warnock): Apl {
  const { apl, shared } = event;
  if (isRoot(event)) {
    if (apl === undefined) throw new Refusal('apl', 'rootNeedsList');
    return { entries: apl };
  }
  if (apl !== undefined) throw new Refusal('apl', 'partHasList');
  return shared === true ? currentApl(now) : { entries: currentApl(now).entries };
}

/** The polygons that may be visible in the window, in the order of the scene. */
export function shownIn({ apl, joined }: Warnock, { polygons }: Scene): readonly string[] {
  const listed = (apl?.entries ?? []).map(([id]) => id);
  const shown = new Set([...listed, ...joined.surrounding.map(({ polygon }) => polygon)]);
  return polygons.map(({ id }) => id).filter((id) => shown.has(id));
}
