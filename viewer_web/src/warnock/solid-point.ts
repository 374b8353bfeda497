import type { View } from '../algorithm/view.js';
import type { Role } from '../picture/mark.js';
import { planeOf } from '../trace/plane.js';
import { holds } from '../solid/plane.js';
import type { N } from '../trace/values.js';
import { shownIn } from './lists.js';

/** The depth of a polygon on the line through the current point. */
export interface PointDepth {
  readonly polygon: string;
  readonly z: N;
  /** Whether the procedure has computed it. A later depth is only drawn. */
  readonly told: boolean;
  readonly role: Role;
}

/** The point whose colour PointColor determines: the middle of the window. */
export function pointInHand({ event, after }: View): readonly [number, number] | null {
  const runs = after.calls.some(({ of }) => of === 'PointColor') || event?.e === 'color';
  const window = after.warnock?.window;
  if (!runs || !window) return null;
  return [window[0] + window[2] / 2, window[1] + window[3] / 2];
}

/** The polygons of the list that contain the point, in the order of the list. */
export function depthsAtPoint(view: View): readonly PointDepth[] {
  const at = pointInHand(view);
  const { warnock } = view.after;
  if (at === null || warnock === undefined) return [];
  const { nearest } = warnock;
  return shownIn(warnock, view.header.scene).flatMap((id): readonly PointDepth[] => {
    const polygon = view.header.scene.byId.get(id);
    if (polygon === undefined || !holds(polygon, ...at)) return [];
    if (nearest?.polygon === id) return [{ polygon: id, z: nearest.z, told: true, role: 'yes' }];
    const z = depthInHand(view, id);
    if (z === null) {
      return [{ polygon: id, z: planeOf(polygon)(...at), told: false, role: 'window' }];
    }
    return [{ polygon: id, z, told: true, role: view.event?.e === 'compare' ? 'no' : 'point' }];
  });
}

function depthInHand({ event }: View, id: string): N | null {
  return (event?.e === 'depth' || event?.e === 'compare') && event.polygon === id ? event.z : null;
}
