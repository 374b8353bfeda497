import type { Scene } from '../trace/header.js';
import type { Rectangle } from './frame.js';

const known = new WeakMap<Scene, Rectangle>();

/** The extent of a scene: the area and all vertices, even those outside. The same scene always gives the same object. */
export function extentOf(scene: Scene): Rectangle {
  const found = known.get(scene) ?? boundsOf(scene);
  known.set(scene, found);
  return found;
}

function boundsOf({ area, polygons }: Scene): Rectangle {
  let [left, top] = [area.x, area.y];
  let [right, bottom] = [area.x + area.width, area.y + area.height];
  for (const { vertices } of polygons) {
    for (const [x, y] of vertices) {
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
    }
  }
  return [left, top, right - left, bottom - top];
}
