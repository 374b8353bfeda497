import type { View } from '../algorithm/view.js';
import { correctedPixel, isCorrected } from '../language/stated.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { N, Point } from '../trace/values.js';
import { box, path, point } from './mark.js';
import type { Mark, Role } from './mark.js';

/** The marks of an event on the picture. */
type Draw<K extends EventName> = (event: Event<K>, view: View) => readonly Mark[];
export type Draws = { readonly [K in EventName]?: Draw<K> };

/** Boxes around runs of pixels in a row. */
export const rowBoxes = (
  role: Role,
  row: number,
  runs: readonly (readonly [number, number])[],
): readonly Mark[] => runs.map(([first, end]) => box(role, [first, row, end - first, 1]));

export const atPoint = ({ point: at }: { readonly point: Point }): readonly Mark[] => [
  point('point', at),
];

/** The pixels that are painted. */
export const painted = ({ runs }: Pick<Event<'draw'>, 'runs'>): readonly Mark[] =>
  runs.flatMap(([row, ...run]) => rowBoxes('touched', row, [run]));

/** A segment of the centre line of a row. */
export const onRow = (row: number, left: N, right: N): Mark =>
  path('side', [
    [left, row + 0.5],
    [right, row + 0.5],
  ]);

/** The marks of events that all algorithms have. */
const common: Draws = {
  depth: atPoint,
  fault: ({ x, y }) => (x === undefined || y === undefined ? [] : [box('off', [x, y, 1, 1])]),
};

/** Where what the run computed is not so, the pixel that shows it is red, or else all that the event marks. */
export function eventMarks(draws: Draws, view: View): readonly Mark[] {
  const { event, sentence } = view;
  if (event === null) return [];
  const draw = (draws[event.e] ?? common[event.e]) as Draw<EventName> | undefined;
  const marks = draw?.(event, view) ?? [];
  if (!isCorrected(sentence)) return marks;
  const pixel = correctedPixel(sentence);
  return pixel === null ? marks.map(inRed) : [...marks, box('wrong', [...pixel, 1, 1])];
}

const inRed = (mark: Mark): Mark =>
  mark.kind === 'note' || mark.kind === 'target' ? mark : { ...mark, role: 'wrong' };

/** The polygon of the step, or else the current polygon of the algorithm. */
export function currentPolygon(
  { event, header }: View,
  id: string | null = null,
): Polygon | undefined {
  const about = event && 'polygon' in event ? event.polygon : id;
  return header.scene.byId.get(about ?? '');
}

export function polygonMark(polygon: Polygon | undefined): readonly Mark[] {
  return polygon ? [{ ...path('active', polygon.vertices, true), color: polygon.color }] : [];
}
