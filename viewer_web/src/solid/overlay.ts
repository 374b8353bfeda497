import type { Frame } from '../picture/frame.js';
import { pathData, shapesOf } from '../picture/shapes.js';
import type { Shape } from '../picture/shapes.js';
import { many } from '../picture/still.js';
import { polygonThing } from '../pointed.js';
import type { Scene } from '../trace/header.js';
import type { Dot, Label, Line } from './drawing.js';
import type { Space } from './space.js';
import { seen } from './turn.js';
import type { Turn } from './turn.js';

/** CSS pixels. */
const textSize = 11.5;
/** Width of a letter of the fixed-width type, as a part of its size. */
const letter = 0.61;
/** CSS pixels between a point and its label. */
const apart = 8;

/** A label as it is seen: where its middle stands, and its size. */
export interface Text {
  readonly label: Label;
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Labels beside their points, on the other side where there is no room. */
export function textsOf(labels: readonly Label[], turn: Turn, frame: Frame): readonly Text[] {
  const size = textSize / frame.scale;
  const [left, top, width, height] = frame.shown;
  return labels.map((label) => {
    const [u, v] = seen(turn, label.at);
    const half = (label.text.length * size * letter) / 2;
    const [across, down] = label.side;
    const x = beside(u, across * (half + apart / frame.scale), half, [left, left + width]);
    return { label, x, y: beside(v, down * size, size / 2, [top, top + height]), size };
  });
}

/** So far from a point, in that direction if what is there stays within the ends. */
function beside(
  at: number,
  by: number,
  half: number,
  [from, to]: readonly [number, number],
): number {
  const isIn = at + by - half >= from && at + by + half <= to;
  return isIn ? at + by : at - by;
}

/** Dots are over all else, hidden or not. */
export const dotShapes = (dots: readonly Dot[], turn: Turn, { scale }: Frame): readonly Shape[] =>
  dots.flatMap(({ role, at }) => shapesOf({ kind: 'point', role, at: seen(turn, at) }, scale));

/** All lines, hidden or not: what is drawn where there is no WebGL. */
export const wires = (lines: readonly Line[], turn: Turn): readonly Shape[] =>
  lines.map(({ look, points, closed, color }) => ({
    look,
    d: pathData(
      points.map((at) => seen(turn, at)),
      closed,
    ),
    ...(color === undefined ? {} : { color }),
  }));

/** Outlines without a look, wide enough to be pointed at. */
export function outlinesToPoint({ polygons }: Scene, space: Space, turn: Turn): readonly Shape[] {
  if (polygons.length > many) return [];
  return polygons.map(({ id, vertices }) => ({
    look: 'to-point',
    d: pathData(
      vertices.map((vertex) => seen(turn, space.place(vertex))),
      true,
    ),
    thing: polygonThing(id),
  }));
}
