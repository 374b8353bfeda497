import { placesOf, showsOf } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';

export type Side = 'state' | 'outline' | 'pixel' | 'exact' | 'solid' | 'predict' | 'bookmarks';

/** The keys that open the panels; not all have one. */
export const sideKeys: Readonly<Partial<Record<Side, string>>> = {
  outline: 'T',
  pixel: 'P',
  exact: 'X',
  solid: 'V',
  predict: 'Q',
  bookmarks: 'Shift B',
};

/** The most polygons in the 3D view. More would block a browser without a graphics card for a minute. */
const mostSolid = 3000;

/**
 * Whether there is a 3D view: it needs a scene with polygons, and code so large that the player alone does not include it.
 */
export const hasSolid = (view: View): boolean => whyNoSolid(view) === null;

/** Why there is no 3D view; null if there is one. */
export function whyNoSolid(view: View): 'noSolid' | 'tooManySolid' | null {
  if (!showsOf(view).isSolid || customElements.get('vidno-solid') === undefined) return 'noSolid';
  return view.header.scene.polygons.length > mostSolid ? 'tooManySolid' : null;
}

/** The name of a panel. */
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
