import type { Bookmarks } from './bookmarks.js';

/** The commands of the controls, which the player carries out. */
export type Command =
  | { readonly do: 'seek'; readonly step: number }
  | { readonly do: 'play' }
  | { readonly do: 'speed'; readonly speed: number }
  | { readonly do: 'bookmarks'; readonly bookmarks: Bookmarks };
