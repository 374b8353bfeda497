import type { Thing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import {
  eventMarks,
  onRow,
  currentPolygon,
  polygonMark,
  rowBoxes,
} from '../picture/event-marks.js';
import type { Draws } from '../picture/event-marks.js';
import { box, edgeOf, path, point } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';
import type { Polygon } from '../trace/header.js';

const polygonOf = ({ header, after }: View): Polygon | undefined =>
  header.scene.byId.get(after.zbuffer?.polygon ?? '');

function stateMarks(view: View): readonly Mark[] {
  const { row = null, y = null, ael = [] } = view.after.zbuffer ?? {};
  const { area } = view.header.scene;
  const polygon = polygonOf(view);
  return [
    ...(row === null ? [] : [box('scanline', [area.x, row, area.width, 1])]),
    ...ael.flatMap(({ edge, x }) => [
      ...edgeOf(polygon, edge, 'edge'),
      ...(y === null ? [] : [point('edge', [x, y])]),
    ]),
  ];
}

const currentEdge = ({ edge }: { readonly edge: number }, view: View): readonly Mark[] =>
  edgeOf(polygonOf(view), edge, 'side');

const draws: Draws = {
  span: ({ row, runs }) => rowBoxes('touched', row, runs),
  pixel: ({ x, y, shown }) => [box(shown ? 'touched' : 'off', [x, y, 1, 1])],
  line: ({ row, from, to }) => [onRow(row, from[0], to[0])],
  columns: ({ first, end }, { after }) =>
    rowBoxes('fresh', after.zbuffer?.row ?? 0, [[first, end]]),
  edge: ({ from, to }) => [path('side', [from, to])],
  horizontal: currentEdge,
  ael_add: currentEdge,
  ael_step: currentEdge,
};

/** The scanline, the active edges, and the pixels that the step paints. */
export const marks = (view: View): readonly Mark[] => [
  ...polygonMark(currentPolygon(view, view.after.zbuffer?.polygon)),
  ...stateMarks(view),
  ...eventMarks(draws, view),
];

export const thingMarks = (thing: Thing, view: View): readonly Mark[] =>
  thing.kind === 'edge' ? edgeOf(polygonOf(view), thing.edge, 'pointed') : [];
