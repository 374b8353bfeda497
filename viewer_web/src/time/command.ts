import type { Bookmarks } from './bookmarks.js';

/** What the controls ask for; the player does it. */
export type Command =
  | { readonly do: 'seek'; readonly step: number }
  | { readonly do: 'play' }
  | { readonly do: 'speed'; readonly speed: number }
  | { readonly do: 'bookmarks'; readonly bookmarks: Bookmarks };
