import type { Frame } from '../picture/frame.js';
import { pathData, shapesOf } from '../picture/shapes.js';
import type { Shape } from '../picture/shapes.js';
import { many } from '../picture/still.js';
import { polygonThing } from '../algorithm/pointed.js';
import type { Scene } from '../trace/header.js';
import type { Dot, Label, Line } from './drawing.js';
import type { Space } from './space.js';
import { seen } from './turn.js';
import type { Turn } from './turn.js';

/** CSS pixels. */
const textSize = 11.5;
/** The width of a letter of the monospaced font, as a share of its size. */
const letter = 0.61;
/** CSS pixels between a point and its label. */
const apart = 8;

/** A label in the view: its centre and size. */
export interface Text {
  readonly label: Label;
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Labels beside their points, or elsewhere near them if there is no room. */
export function textsOf(labels: readonly Label[], turn: Turn, frame: Frame): readonly Text[] {
  const texts: Text[] = [];
  for (const label of labels) {
    const places = placesOf(label, turn, frame);
    const inside = places.filter((place) => isIn(place, frame));
    const free = inside.find((place) => !texts.some((text) => doOverlap(text, place)));
    const found = free ?? inside[0] ?? places[0];
    if (found !== undefined) texts.push(found);
  }
  return texts;
}

/** The possible places of a label, the best one first. A label centred on its point has only that place. */
function placesOf(label: Label, turn: Turn, frame: Frame): readonly Text[] {
  const size = textSize / frame.scale;
  const [u, v] = seen(turn, label.at);
  const [across, down] = label.side;
  const away = halfOf({ label, size }) + apart / frame.scale;
  const lines = across === 0 ? [down, -down] : [0, -1, 1, -2, 2].map((by) => down + by);
  return lines.flatMap((line) =>
    [across, -across].map((side) => ({ label, x: u + side * away, y: v + line * size, size })),
  );
}

/** Half the width of a text. */
const halfOf = ({ label, size }: Pick<Text, 'label' | 'size'>): number =>
  (label.text.length * size * letter) / 2;

function isIn(text: Text, { shown: [left, top, width, height] }: Frame): boolean {
  const { x, y, size } = text;
  const half = halfOf(text);
  const isAcross = x - half >= left && x + half <= left + width;
  return isAcross && y - size / 2 >= top && y + size / 2 <= top + height;
}

/** Whether two texts overlap; adjacent lines do not. */
function doOverlap(a: Text, b: Text): boolean {
  const isBeside = Math.abs(a.x - b.x) >= halfOf(a) + halfOf(b);
  return !isBeside && Math.abs(a.y - b.y) < 0.99 * a.size;
}

/** Dots are over everything else, even if hidden. */
export const dotShapes = (dots: readonly Dot[], turn: Turn, { scale }: Frame): readonly Shape[] =>
  dots.flatMap(({ role, at }) => shapesOf({ kind: 'point', role, at: seen(turn, at) }, scale));

/** All lines, hidden or not, for browsers without WebGL. */
export const wires = (lines: readonly Line[], turn: Turn): readonly Shape[] =>
  lines.map(({ look, points, closed, color }) => ({
    look,
    d: pathData(
      points.map((at) => seen(turn, at)),
      closed,
    ),
    ...(color === undefined ? {} : { color }),
  }));

/** Invisible outlines, wide enough to point at. */
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
