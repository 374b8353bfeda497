import type { View } from '../algorithm/view.js';
import type { Polygon } from '../trace/header.js';
import { path } from './mark.js';
import type { Mark } from './mark.js';

/** The polygon of the step, or else the current polygon of the algorithm. */
export function polygonInHand(
  { event, header }: View,
  id: string | null = null,
): Polygon | undefined {
  const about = event && 'polygon' in event ? event.polygon : id;
  return header.scene.byId.get(about ?? '');
}

export function polygonMark(polygon: Polygon | undefined): readonly Mark[] {
  return polygon ? [{ ...path('active', polygon.vertices, true), color: polygon.color }] : [];
}
