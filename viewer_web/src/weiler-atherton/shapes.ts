import { atPoint, eventMarks, onRow, painted, rowBoxes } from '../picture/event-marks.js';
import type { Draws } from '../picture/event-marks.js';
import { figureFrame, figureOf as polygonsFigure } from '../picture/figure.js';
import type { Frame } from '../picture/frame.js';
import { isShown, point, spot } from '../picture/mark.js';
import type { Mark, Spot } from '../picture/mark.js';
import { circleData, diamondData, pathData } from '../picture/shapes.js';
import type { Shape } from '../picture/shapes.js';
import type { WeilerAtherton } from '../replay/values.js';
import type { Event, EventName } from '../trace/events.js';
import type { Area, Scene } from '../trace/header.js';
import type { Piece, Point, Region } from '../trace/values.js';
import type { View } from '../algorithm/view.js';
import { hatchData, regionData } from './geometry.js';
import { emptyWeilerAtherton, currentListOf } from './state.js';
import type { Crossings, List } from './state.js';

/** The layers in the picture of a run with regions, each with a switch. */
export const regionLayers = ['pixels', 'visible', 'list', 'parts', 'crossings'] as const;
export type RegionLayer = (typeof regionLayers)[number];

export const allLayers: ReadonlySet<RegionLayer> = new Set(regionLayers);

/** CSS pixels: the size of the mark of a crossing, and the distance between hatching lines. */
const crossingSize = 6;
const hatch = { inside: 6, outside: 8 } as const;

/** Entering crossings are full diamonds and leaving ones are rings, so they are distinguishable without colours. */
export const crossingData = { enters: diamondData, leaves: circleData } as const;

const outlines = (pieces: List): string => pieces.map(([, region]) => regionData(region)).join('');

const casing = (look: string, d: string): readonly Shape[] => [
  { look: `casing ${look}`, d },
  { look, d },
];

/** Whether there is a list. Before that, the polygons themselves are drawn. */
const isBegun = ({ lists, currentList }: WeilerAtherton): boolean =>
  lists.length > 0 || currentList !== null;

/** The piece that is being processed, or that the step has divided into inside and outside. */
function subjectOf(view: View): Piece | undefined {
  const { event } = view;
  const currentList = currentListOf(view);
  if (currentList === null) return undefined;
  const isDone = event?.e === 'clipped' || event?.e === 'beside';
  const isOver = event !== null && !isDone && !inClip.includes(event.e);
  return isOver ? undefined : currentList.pieces[currentList.seen - (isDone ? 1 : 0)];
}
const inClip: readonly EventName[] = ['call', 'edge_piece', 'entering', 'leaving', 'pop_list'];

/** The crossings of the current clipping, or of the one that the step ended. */
function crossingsOf({ before, after, event }: View): Crossings {
  const isEnd = event?.e === 'clipped' || event?.e === 'cut_to_area';
  return ((isEnd ? before.weilerAtherton : after.weilerAtherton) ?? emptyWeilerAtherton).crossings;
}

function crossingShapes(look: keyof typeof crossingData, at: readonly Point[], r: number): Shape {
  const spots = at.map(spot).filter(isShown);
  return { look, d: spots.map((each) => crossingData[look](each, r)).join('') };
}

const colorOf = (scene: Scene, id: string): string => scene.byId.get(id)?.color ?? '#888888';

/** Hatched parts, with different directions for inside and outside. */
function partShapes(
  part: 'inside' | 'outside',
  regions: readonly Region[],
  frame: Frame,
): readonly Shape[] {
  const apart = hatch[part] / frame.scale;
  const slope = part === 'inside' ? 1 : -1;
  const lines = regions.map((region) => hatchData(region, slope, apart, frame.shown)).join('');
  return [
    { look: `${part}-part`, d: lines },
    { look: `${part}-part outline`, d: regions.map(regionData).join('') },
  ];
}

type Draw = (view: View, frame: Frame) => readonly Shape[];

const layers: Readonly<Record<Exclude<RegionLayer, 'pixels' | 'visible'>, Draw>> = {
  list: (view) => {
    const regions = view.after.weilerAtherton ?? emptyWeilerAtherton;
    if (!isBegun(regions)) return [{ look: 'facet', d: outlines(regions.facets) }];
    const currentList = currentListOf(view);
    const clip = currentList?.pieces[0];
    const subject = subjectOf(view);
    return [
      { look: 'listed', d: outlines(currentList?.pieces.slice(1) ?? []) },
      ...(clip === undefined ? [] : casing('clip-region', regionData(clip[1]))),
      ...(subject === undefined ? [] : casing('subject', regionData(subject[1]))),
    ];
  },
  parts: (view, frame) => {
    const { event } = view;
    if (event?.e === 'clipped' && event.at === 'SP1') {
      return partShapes('inside', [event.inside], frame);
    }
    const currentList = currentListOf(view);
    const regionsOf = (list: List = []): readonly Region[] => list.map(([, region]) => region);
    return [
      ...partShapes('outside', regionsOf(currentList?.outside), frame),
      ...partShapes('inside', regionsOf(currentList?.inside), frame),
    ];
  },
  crossings: (view, { scale }) => {
    const { entering, leaving } = crossingsOf(view);
    const r = crossingSize / scale;
    return [crossingShapes('enters', entering, r), crossingShapes('leaves', leaving, 0.8 * r)];
  },
};

/** A line, clipped to the area. */
function lineThrough(at: Point, normal: Point, { x, y, width, height }: Area): string {
  const [px, py] = spot(at);
  const [a, b] = spot(normal);
  const way: Spot = [-b, a];
  const sides = [
    [(x - px) / way[0], (x + width - px) / way[0]],
    [(y - py) / way[1], (y + height - py) / way[1]],
  ].filter((ends) => ends.every(Number.isFinite));
  const from = Math.max(...sides.map((ends) => Math.min(...ends)));
  const to = Math.min(...sides.map((ends) => Math.max(...ends)));
  const ends = [from, to].map((t): Spot => [px + t * way[0], py + t * way[1]]);
  return from < to && ends.flat().every(Number.isFinite) ? pathData(ends, false) : '';
}

type OfEvent<K extends EventName> = (event: Event<K>, view: View) => readonly Shape[];

/** The shapes of the step itself. */
const ofStep: { readonly [K in EventName]?: OfEvent<K> } = {
  cut_to_area: ({ region }) => casing('newly', regionData(region)),
  split: ({ region, other }) => casing('newly', regionData(region) + regionData(other)),
  edge_piece: ({ from, to }) => [
    { look: 'edge-piece', d: pathData([spot(from), spot(to)], false) },
  ],
  show: ({ region }) => casing('newly', regionData(region)),
  push_list: ({ pieces }) => [{ look: 'newly', d: outlines(pieces) }],
};

function stepShapes(event: Event, view: View): readonly Shape[] {
  const draw = ofStep[event.e] as OfEvent<EventName> | undefined;
  return draw?.(event, view) ?? [];
}

/** The visible regions so far, each in its polygon's colour. */
export function visibleShapes(
  { after, header: { scene } }: View,
  shown: ReadonlySet<RegionLayer>,
): readonly Shape[] {
  if (!shown.has('visible')) return [];
  return (after.weilerAtherton ?? emptyWeilerAtherton).visible.map(([id, region]) => ({
    look: 'shown',
    d: regionData(region),
    fill: colorOf(scene, id),
  }));
}

const order: readonly (keyof typeof layers)[] = ['parts', 'list', 'crossings'];

/** The other shapes of regions at a step; later ones are on top. */
export function regionShapes(
  view: View,
  frame: Frame,
  shown: ReadonlySet<RegionLayer>,
): readonly Shape[] {
  const { event, after, header } = view;
  const { piercing } = after.weilerAtherton ?? emptyWeilerAtherton;
  const line =
    piercing === null ? '' : lineThrough(piercing.point, piercing.normal, header.scene.area);
  return [
    ...order.filter((layer) => shown.has(layer)).flatMap((layer) => layers[layer](view, frame)),
    { look: 'piercing-line', d: line },
    ...(event === null ? [] : stepShapes(event, view)),
  ].filter(({ d }) => d !== '');
}

const draws: Draws = {
  paint: painted,
  behind: ({ point: at, behind }) => [point(behind ? 'no' : 'yes', at)],
  order: atPoint,
  row: ({ row, left, right, first, end }) => [
    onRow(row, left, right),
    ...rowBoxes('fresh', row, [[first, end]]),
  ],
};

/** The marks of the step's decision; the current pieces are drawn as regions. */
export const marks = (view: View): readonly Mark[] => eventMarks(draws, view);

/** The picture at a step with its regions, as a separate SVG document; see `figureOf`. */
export const figureOf = (view: View): string =>
  polygonsFigure(view, {
    under: visibleShapes(view, allLayers),
    over: regionShapes(view, figureFrame(view), allLayers),
  });
