import type { Scene } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Warnock } from './state.js';

/** The windows that were divided on the way to the next one. */
export function wayTo(next: Box, { way, window }: Pick<Warnock, 'way' | 'window'>): readonly Box[] {
  return (window === null ? way : [...way, window]).filter((each) => holds(each, next));
}

const holds = ([x, y, width, height]: Box, [left, top, across, down]: Box): boolean =>
  x <= left && y <= top && left + across <= x + width && top + down <= y + height;

/** The polygons that may be visible in the window, in the order of the scene. */
export function shownIn({ apl, joined }: Warnock, { polygons }: Scene): readonly string[] {
  const listed = (apl?.entries ?? []).map(([id]) => id);
  const shown = new Set([...listed, ...joined.surrounding.map(({ polygon }) => polygon)]);
  return polygons.map(({ id }) => id).filter((id) => shown.has(id));
}
