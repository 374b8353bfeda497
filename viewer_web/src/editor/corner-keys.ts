import { moves } from '../picture/pixel.js';
import type { Act } from './editor.js';
import * as sketch from '../run/sketch.js';
import type { Sketch, Spot, Vertex } from '../run/sketch.js';

export type Place = readonly [x: number, y: number];

/** Corners lie on quarters of a pixel, with Alt on 64ths. */
const coarse = 4;
const fine = 64;
const depthStep = 1 / 16;

/** The nearest allowed place of a corner. */
export function snapped([x, y]: Place, { altKey }: Pick<MouseEvent, 'altKey'>): Place {
  const parts = altKey ? fine : coarse;
  return [Math.round(x * parts) / parts, Math.round(y * parts) / parts];
}

/** The place that an arrow key moves to: a quarter of a pixel on, with Shift a pixel, with Alt a 64th. */
export function led([x, y]: Place, { key, shiftKey, altKey }: KeyboardEvent): Place | null {
  const way = moves[key];
  if (way === undefined) return null;
  const by = altKey ? 1 / fine : shiftKey ? 1 : 1 / coarse;
  return [x + way[0] * by, y + way[1] * by];
}

/**
 * The action of a key on the focused corner. It starts from where earlier keys, possibly not yet shown, have moved the
 * corner.
 */
export function cornerAct(event: KeyboardEvent, spot: Spot): Act | null {
  const { key } = event;
  const name = `${key} ${spot.polygon} ${spot.vertex}`;
  const edit = (change: (old: Sketch, corner: Vertex) => Sketch, steady?: string): Act => ({
    do: 'edit',
    edit: (old) => {
      const corner = old.polygons[spot.polygon]?.vertices[spot.vertex];
      return corner === undefined ? old : change(old, corner);
    },
    ...(steady === undefined ? {} : { name: steady }),
  });
  if (key in moves) {
    const move = (old: Sketch, [x, y]: Vertex): Sketch => {
      const to = led([x, y], event);
      return to === null ? old : sketch.moveVertex(old, spot, ...to);
    };
    return edit(move, name);
  }
  if (key === 'PageUp' || key === 'PageDown') {
    const by = key === 'PageUp' ? depthStep : -depthStep;
    const depth = (z: number): number => Math.min(1, Math.max(-1, z + by));
    return edit((old, [, , z]) => sketch.setDepth(old, spot, depth(z)), name);
  }
  if (key === 'Delete') return edit((old) => sketch.removeVertex(old, spot));
  if (key === '+') return edit((old) => sketch.splitEdge(old, spot));
  return null;
}
