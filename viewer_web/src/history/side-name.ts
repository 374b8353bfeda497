import { placesOf, showsOf } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';

export type Side = 'state' | 'outline' | 'pixel' | 'exact' | 'solid' | 'predict' | 'bookmarks';

/** The key that opens each, where there is one. */
export const sideKeys: Readonly<Partial<Record<Side, string>>> = {
  outline: 'T',
  pixel: 'P',
  exact: 'X',
  solid: 'V',
  predict: 'Q',
  bookmarks: 'Shift B',
};

/** Polygons that 3D can draw: of more, it would keep a browser without a graphics card busy for a minute. */
const mostSolid = 3000;

/** Whether there is a scene in 3D, and the page brings along what shows it, which is large; a player alone does not. */
export const hasSolid = (view: View): boolean => whyNoSolid(view) === null;

/** Why there is none. */
export function whyNoSolid(view: View): 'noSolid' | 'tooManySolid' | null {
  if (!showsOf(view).isSolid || customElements.get('vidno-solid') === undefined) return 'noSolid';
  return view.header.scene.polygons.length > mostSolid ? 'tooManySolid' : null;
}

/** What a panel is called. */
export function sideName(side: Side, view: View): string {
  const { bookmarks, exact, outline, solid, predict } = texts[view.language];
  const names: Readonly<Record<Side, string>> = {
    state: view.texts.state,
    outline: outline.title,
    pixel: placesOf(view).pixel,
    exact: exact.exactness,
    solid: solid.solid,
    predict: predict.title,
    bookmarks: bookmarks.title,
  };
  return names[side];
}
