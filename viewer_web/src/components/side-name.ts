import { texts } from '../i18n/index.js';
import type { View } from '../view.js';
import { placesOf, showsOf } from './shows.js';

export type Side = 'state' | 'pixel' | 'exact' | 'solid' | 'predict' | 'bookmarks' | 'scene';

/** Whether there is a scene in 3D, and the page brings along what shows it, which is large; a player alone does not. */
export const hasSolid = (view: View): boolean =>
  showsOf(view).isSolid && customElements.get('vidno-solid') !== undefined;

/** What a panel is called. */
export function sideName(side: Side, view: View): string {
  const { bookmarks, scene, exact, solid, predict } = texts[view.language];
  const names: Readonly<Record<Side, string>> = {
    state: view.texts.state,
    pixel: placesOf(view).pixel,
    exact: exact.exactness,
    solid: solid.solid,
    scene: scene.scene,
    predict: predict.title,
    bookmarks: bookmarks.title,
  };
  return names[side];
}
