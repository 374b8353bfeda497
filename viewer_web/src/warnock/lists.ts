import type { Scene } from '../trace/header.js';
import type { Warnock } from './state.js';

/** The polygons that may be visible in the window, in the order of the scene. */
export function shownIn({ apl, joined }: Warnock, { polygons }: Scene): readonly string[] {
  const listed = (apl?.entries ?? []).map(([id]) => id);
  const shown = new Set([...listed, ...joined.surrounding.map(({ polygon }) => polygon)]);
  return polygons.map(({ id }) => id).filter((id) => shown.has(id));
}
