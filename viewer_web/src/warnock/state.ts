import type { Warnock } from '../replay/values.js';

export type { Apl, Entry, StackedWindow, Warnock } from '../replay/values.js';
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
