import { thingOf } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { Sight } from '../replay/quadtree.js';
import { containmentMarks, splitMarks } from '../warnock/containment-marks.js';
import { box, cornerOf, edgeOf, path, point, target } from './mark.js';
import type { Mark, Role } from './mark.js';
import type { Corner, N, Point, Vertex } from '../trace/values.js';

/** How the area is divided into windows, and the way to the current one. */
function treeMarks({ screen, after }: View, sight: Sight): readonly Mark[] {
  const { root, way = [] } = after.warnock ?? {};
  if (!root) return [];
  return [
    { kind: 'boxes', role: 'tree', boxes: screen.windows(root, sight) },
    { kind: 'boxes', role: 'way', boxes: way },
  ];
}

/** What stands on the picture because of the state. */
function stateMarks({ after, header: { scene } }: View): readonly Mark[] {
  const { warnock, zbuffer } = after;
  const marks: Mark[] = [];
  for (const { window } of warnock?.stack ?? []) marks.push(box('stacked', window));
  if (warnock?.window) marks.push(box('window', warnock.window));
  if (warnock?.clip) {
    marks.push(path('clip', warnock.clip.vertices, true));
    marks.push(path('clip-new', warnock.clip.next));
    for (const vertex of warnock.clip.next) marks.push(point('clip-new', vertex));
  }
  marks.push(...containmentMarks(warnock, scene));
  const { area } = scene;
  if (zbuffer?.row != null) marks.push(box('scanline', [area.x, zbuffer.row, area.width, 1]));
  const polygon = scene.byId.get(zbuffer?.polygon ?? '');
  for (const { edge, x } of zbuffer?.ael ?? []) {
    marks.push(...edgeOf(polygon, edge, 'edge'));
    if (zbuffer?.y != null) marks.push(point('edge', [x, zbuffer.y]));
  }
  return marks;
}

const rowBoxes = (
  role: Role,
  row: number,
  runs: readonly (readonly [number, number])[],
): readonly Mark[] => runs.map(([first, end]) => box(role, [first, row, end - first, 1]));

type Draw<K extends EventName> = (event: Event<K>, view: View) => readonly Mark[];

const atPoint = ({ point: at }: { readonly point: Point }): readonly Mark[] => [point('point', at)];
const keptVertex = ({ vertex }: { readonly vertex: Vertex }): readonly Mark[] => [
  point('yes', vertex),
];

/** The pixels that take a colour. */
const painted = ({ runs }: Pick<Event<'draw'>, 'runs'>): readonly Mark[] =>
  runs.flatMap(([row, ...run]) => rowBoxes('touched', row, [run]));

function edgeInHand({ edge }: { readonly edge: number }, view: View): readonly Mark[] {
  const { header, after } = view;
  return edgeOf(header.scene.byId.get(after.zbuffer?.polygon ?? ''), edge, 'side');
}

function cornerMarks(view: View, corners: readonly Corner[], role: Role): readonly Mark[] {
  const window = view.after.warnock?.window;
  return window ? corners.map((corner) => point(role, cornerOf(window, corner))) : [];
}

/** A piece of the centre line of a row. */
const onRow = (row: number, left: N, right: N): Mark =>
  path('side', [
    [left, row + 0.5],
    [right, row + 0.5],
  ]);

/** What stands on the picture because of the step itself. */
const draw: { readonly [K in EventName]?: Draw<K> } = {
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
  paint: painted,
  behind: ({ point: at, behind }) => [point(behind ? 'no' : 'yes', at)],
  order: atPoint,
  span: ({ row, runs }) => rowBoxes('touched', row, runs),
  pixel: ({ x, y, shown }) => [box(shown ? 'touched' : 'off', [x, y, 1, 1])],
  depth: atPoint,
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
  line: ({ row, from, to }) => [onRow(row, from[0], to[0])],
  columns: ({ first, end }, { after }) =>
    rowBoxes('fresh', after.zbuffer?.row ?? 0, [[first, end]]),
  edge: ({ from, to }) => [path('side', [from, to])],
  horizontal: edgeInHand,
  ael_add: edgeInHand,
  ael_step: edgeInHand,
  fault: ({ x, y }) => (x === undefined || y === undefined ? [] : [box('off', [x, y, 1, 1])]),
};

function eventMarks(event: Event, view: View): readonly Mark[] {
  const marks = draw[event.e] as Draw<EventName> | undefined;
  return marks?.(event, view) ?? [];
}

function isFinite(mark: Mark): boolean {
  if (mark.kind !== 'point' && mark.kind !== 'note' && mark.kind !== 'path') return true;
  const spots = mark.kind === 'path' ? mark.points : [mark.at];
  return spots.every(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
}

/** The polygon that the step is about, or the one in hand. */
export function polygonInHand({ event, header, after }: View): Polygon | undefined {
  const id = event && 'polygon' in event ? event.polygon : after.zbuffer?.polygon;
  return header.scene.byId.get(id ?? '');
}

/** Of regions the piece in hand is marked instead. */
function polygonMark(view: View): readonly Mark[] {
  if (view.after.regions !== null) return [];
  const polygon = polygonInHand(view);
  return polygon ? [{ ...path('active', polygon.vertices, true), color: polygon.color }] : [];
}

function thingMarks(text: string, view: View): readonly Mark[] {
  const thing = thingOf(text, view);
  const { scene } = view.header;
  const { warnock, zbuffer } = view.after;
  if (thing?.kind === 'polygon') {
    const polygon = scene.byId.get(thing.id);
    return polygon ? [path('pointed', polygon.vertices, true)] : [];
  }
  if (thing?.kind === 'edge') {
    return edgeOf(scene.byId.get(zbuffer?.polygon ?? ''), thing.edge, 'pointed');
  }
  if (thing?.kind === 'window') return [box('pointed', thing.window)];
  if (thing?.kind === 'pixel') return [box('pointed', [...thing.at, 1, 1])];
  if (thing?.kind === 'corner' && warnock?.window) {
    return [point('pointed', cornerOf(warnock.window, thing.corner))];
  }
  return [];
}

/** What is asked about, and what is pointed at anywhere on the page. */
function pointedMarks(view: View): readonly Mark[] {
  const { asked = [], pointed } = view;
  const things = pointed === null ? asked : [...asked, pointed];
  return things.flatMap((thing) => thingMarks(thing, view));
}

/** All marks of a step that are in sight, those above later. */
export function marksOf(view: View, sight: Sight): readonly Mark[] {
  const ofEvent = view.event ? eventMarks(view.event, view) : [];
  const chosen = view.pixel === null ? [] : [target('chosen', view.pixel)];
  const ofState = [...treeMarks(view, sight), ...polygonMark(view), ...stateMarks(view)];
  return [...ofState, ...ofEvent, ...pointedMarks(view), ...chosen].filter(isFinite);
}
