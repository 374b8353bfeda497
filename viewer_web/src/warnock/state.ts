import type { Warnock } from '../replay/values.js';
import type { Scene } from '../trace/header.js';

/** Polygons that surround a window or are outside it, each with the level of the window at which it joined the list. */
export type Joined = Warnock['joined']['surrounding'];

/** What was found about a window. */
type Found = Warnock['last'];
const nothingFound: Found = {
  corners: null,
  k: null,
  count: null,
  hasSurround: null,
  color: null,
  insider: null,
};

/** Before the first step. */
export const emptyWarnock: Warnock = {
  root: null,
  way: [],
  stack: [],
  window: null,
  apl: null,
  joined: { surrounding: [], outside: [] },
  contained: [],
  ...nothingFound,
  covering: null,
  clip: null,
  depths: [],
  nearest: null,
  last: { ...nothingFound, count: 0, hasSurround: false, insider: false },
};

/** The polygons that may be visible in the window, in the order of the scene. */
export function shownIn({ apl, joined }: Warnock, { polygons }: Scene): readonly string[] {
  const listed = (apl?.entries ?? []).map(([id]) => id);
  const shown = new Set([...listed, ...joined.surrounding.map(({ polygon }) => polygon)]);
  return polygons.map(({ id }) => id).filter((id) => shown.has(id));
}
