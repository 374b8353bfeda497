import type { Thing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import {
  atPoint,
  eventMarks,
  onRow,
  painted,
  currentPolygon,
  polygonMark,
  rowBoxes,
} from '../picture/event-marks.js';
import type { Draws } from '../picture/event-marks.js';
import { box, cornerOf, edgeOf, path, point } from '../picture/mark.js';
import type { Mark, Role } from '../picture/mark.js';
import type { Sight } from '../replay/screen.js';
import type { Corner, Vertex } from '../trace/values.js';
import { containmentMarks, splitMarks } from './containment-marks.js';

/** The division of the area into windows, and the windows that contain the current one. */
function treeMarks({ screen, after }: View, sight: Sight): readonly Mark[] {
  const { root, way = [] } = after.warnock ?? {};
  if (!root) return [];
  return [
    { kind: 'boxes', role: 'tree', boxes: screen.windows(sight) },
    { kind: 'boxes', role: 'way', boxes: way },
  ];
}

function stateMarks({ after: { warnock }, header: { scene } }: View): readonly Mark[] {
  if (warnock === undefined) return [];
  const { stack, window, clip } = warnock;
  return [
    ...stack.map((each) => box('stacked', each.window)),
    ...(window === null ? [] : [box('window', window)]),
    ...(clip === null
      ? []
      : [
          path('clip', clip.vertices, true),
          path('clip-new', clip.next),
          ...clip.next.map((vertex) => point('clip-new', vertex)),
        ]),
    ...containmentMarks(warnock, scene),
  ];
}

const keptVertex = ({ vertex }: { readonly vertex: Vertex }): readonly Mark[] => [
  point('yes', vertex),
];

function cornerMarks(view: View, corners: readonly Corner[], role: Role): readonly Mark[] {
  const window = view.after.warnock?.window;
  return window ? corners.map((corner) => point(role, cornerOf(window, corner))) : [];
}

const draws: Draws = {
  push: ({ window }) => [box('fresh', window)],
  skip: ({ window }) => [box('off', window)],
  fill: ({ rect }) => [box('touched', rect)],
  back_face: ({ polygon, away }, { header }) => [
    path(away ? 'off' : 'touched', header.scene.byId.get(polygon)?.vertices ?? [], true),
  ],
  trial: ({ polygon, edge, meets }, { header }) =>
    edgeOf(header.scene.byId.get(polygon), edge, meets ? 'side' : 'off'),
  split_vertex: splitMarks,
  edge_depth: ({ polygon, edge }, { header }) =>
    edgeOf(header.scene.byId.get(polygon), edge, 'side'),
  draw: painted,
  color: atPoint,
  surround: ({ point: at, inside }) => [point(inside ? 'yes' : 'no', at)],
  orient: ({ polygon, edge, point: at }, { header }) => [
    ...edgeOf(header.scene.byId.get(polygon), edge, 'side'),
    point('point', at),
  ],
  compare: ({ corner, nearer }, view) =>
    cornerMarks(view, corner ? [corner] : [], nearer ? 'yes' : 'no'),
  nearer: ({ corners }, view) => cornerMarks(view, corners, 'yes'),
  clip_side: ({ from, to }) => [path('side', [from, to])],
  clip_sign: ({ vertex, sign }) => [point(sign > 0 ? 'no' : 'yes', vertex)],
  clip_cross: keptVertex,
  clip_keep: keptVertex,
  clip_drop: ({ vertex }) => [point('no', vertex)],
  clip_result: ({ vertices }) => [path('clip', vertices, true)],
  row: ({ row, left, right, first, end }) => [
    onRow(row, left, right),
    ...rowBoxes('fresh', row, [[first, end]]),
  ],
};

/** The windows, the clipped polygon, and the decision of the step. */
export const marks = (view: View, sight: Sight): readonly Mark[] => [
  ...treeMarks(view, sight),
  ...polygonMark(currentPolygon(view)),
  ...stateMarks(view),
  ...eventMarks(draws, view),
];

export const thingMarks = (thing: Thing, view: View): readonly Mark[] =>
  thing.kind === 'corner' ? cornerMarks(view, [thing.corner], 'pointed') : [];
