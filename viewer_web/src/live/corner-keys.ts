import { moves } from '../picture/pixel.js';
import type { Act } from './editor.js';
import * as sketch from './sketch.js';
import type { Sketch, Spot } from './sketch.js';

export type Place = readonly [x: number, y: number];

/** Corners stand on quarters of a pixel, with Alt on 64ths. */
const coarse = 4;
const fine = 64;
const depthStep = 1 / 16;

/** The nearest place where a corner may stand. */
export function snapped([x, y]: Place, { altKey }: Pick<MouseEvent, 'altKey'>): Place {
  const parts = altKey ? fine : coarse;
  return [Math.round(x * parts) / parts, Math.round(y * parts) / parts];
}

/** Where an arrow key leads: a quarter of a pixel on, with Shift a pixel, with Alt a 64th. */
export function led([x, y]: Place, { key, shiftKey, altKey }: KeyboardEvent): Place | null {
  const way = moves[key];
  if (way === undefined) return null;
  const by = altKey ? 1 / fine : shiftKey ? 1 : 1 / coarse;
  return [x + way[0] * by, y + way[1] * by];
}

/** What a key does to a corner that has the focus. */
export function cornerAct(event: KeyboardEvent, drawn: Sketch, spot: Spot): Act | null {
  const { key } = event;
  const [x, y, z] = drawn.polygons[spot.polygon]?.vertices[spot.vertex] ?? [0, 0, 0];
  const name = `${key} ${spot.polygon} ${spot.vertex}`;
  const to = led([x, y], event);
  if (to !== null) {
    return { do: 'edit', edit: (old) => sketch.moveVertex(old, spot, ...to), name };
  }
  if (key === 'PageUp' || key === 'PageDown') {
    const depth = Math.min(1, Math.max(-1, z + (key === 'PageUp' ? depthStep : -depthStep)));
    return { do: 'edit', edit: (old) => sketch.setDepth(old, spot, depth), name };
  }
  if (key === 'Delete') return { do: 'edit', edit: (old) => sketch.removeVertex(old, spot) };
  if (key === '+') return { do: 'edit', edit: (old) => sketch.splitEdge(old, spot) };
  return null;
}
