import { toNumber } from '../language/words.js';
import { figureDocument, figureFrame, pathOf } from '../picture/figure.js';
import type { Frame } from '../picture/frame.js';
import { isShown, spot } from '../picture/mark.js';
import type { Spot } from '../picture/mark.js';
import { boxData, circleData, diamondData, pathData } from '../picture/shapes.js';
import type { Shape } from '../picture/shapes.js';
import { curveThing, thingOf } from '../algorithm/pointed.js';
import { hasDefect } from '../trace/editions.js';
import type { FloatingHorizonEvents, Event } from '../trace/events.js';
import type { Area, Curve, CurveSample } from '../trace/header.js';
import type { View } from '../algorithm/view.js';
import type { Sample } from '../trace/values.js';
import type { Flag, Heights } from './state.js';
import type { Line } from '../replay/values.js';

export const hasPoint = (sample: CurveSample): sample is Sample => sample[1] !== null;

/** Neighbouring samples with points, at least two: a curve with gaps has several pieces, or none. */
export function piecesOf(curve: Curve): readonly (readonly Sample[])[] {
  const pieces: Sample[][] = [[]];
  for (const sample of curve) {
    if (hasPoint(sample)) pieces.at(-1)?.push(sample);
    else pieces.push([]);
  }
  return pieces.filter(({ length }) => length >= 2);
}

type FlagLook = 'above' | 'below' | 'hidden' | 'both';
export const flagLooks: Readonly<Record<`${Flag}`, FlagLook>> = {
  1: 'above',
  '-1': 'below',
  0: 'hidden',
  2: 'both',
};

/** A triangle that points towards the curve, a ring for hidden, a diamond for both. */
const flagData: Readonly<Record<FlagLook, (at: Spot, r: number) => string>> = {
  above: ([x, y], r) => `M${x - r} ${y + 0.7 * r}h${2 * r}l${-r} ${-1.7 * r}Z`,
  below: ([x, y], r) => `M${x - r} ${y - 0.7 * r}h${2 * r}l${-r} ${1.7 * r}Z`,
  hidden: (at, r) => circleData(at, 0.8 * r),
  both: diamondData,
};

/** The layers in the picture of a run of curves, each with a switch. */
export const curveLayers = ['lines', 'curve', 'horizons', 'columns', 'edges'] as const;
export type Layer = (typeof curveLayers)[number];

/** The choice of all layers. */
export const allLayers: ReadonlySet<Layer> = new Set(curveLayers);
export const linesAlone: ReadonlySet<Layer> = new Set<Layer>(['lines']);

/** CSS pixels: the largest mark of a flag, and a dot of the step. */
const flagSize = 4;
const dot = 4.5;
/** Samples at least this far apart have dots of their own. */
const samplesApart = 6;

const parts = new WeakMap<Line, string>();

/** The path data of a line, cached: there may be thousands of lines, and a step changes one. */
function lineData(line: Line): string {
  const known = parts.get(line);
  if (known !== undefined) return known;
  const ends = [spot(line.from), spot(line.to)];
  const d = ends.every(isShown) ? pathData(ends, false) : '';
  parts.set(line, d);
  return d;
}

/** The height at which to draw a curve over a column; null where the curve does not exist. */
export function heightOver(curve: Curve, column: number): number | null {
  const next = curve.findIndex(([x]) => x >= column);
  const [x2, y2] = curve[next] ?? [NaN, NaN];
  if (x2 === column) return y2;
  const [x1, y1] = curve[next - 1] ?? [NaN, null];
  if (y1 === null || y2 === null) return null;
  return y1 + ((y2 - y1) * (column - x1)) / (x2 - x1);
}

/** A horizon from column to column where it exists; a short bar over an isolated column. */
function horizonData(heights: Heights, { x, width }: Area): string {
  const pieces: string[] = [];
  let piece: Spot[] = [];
  const end = (): void => {
    const [only] = piece;
    if (piece.length > 1) pieces.push(pathData(piece, false));
    else if (only !== undefined) pieces.push(`M${only[0] - 0.2} ${only[1]}h0.4`);
    piece = [];
  };
  for (let i = 0; i < width; i++) {
    const height = heights[i] ?? null;
    const at: Spot = [x + i, height === null ? NaN : toNumber(height)];
    if (isShown(at)) piece.push(at);
    else end();
  }
  end();
  return pieces.join('');
}

const currentCurve = ({ header, after }: View): Curve | null =>
  header.scene.curves?.[after.floatingHorizon?.curve ?? -1] ?? null;

const first = (curve: Curve): Spot | null => piecesOf(curve)[0]?.[0] ?? null;
const last = (curve: Curve): Spot | null => piecesOf(curve).at(-1)?.at(-1) ?? null;

/**
 * Lines through the ends of the curves, with a gap at a curve that has no end. The end of the last one may not have been reached
 * yet.
 */
function sideEdge(ends: readonly (Spot | null)[], reached: Spot | null): Shape {
  const isReached = ends.at(-1)?.join() === reached?.join();
  const lines: Spot[][] = [[]];
  for (const end of isReached ? ends : ends.slice(0, -1)) {
    if (end === null) lines.push([]);
    else lines.at(-1)?.push(end);
  }
  const d = lines.map((line) => (line.length === 0 ? '' : pathData(line, false))).join('');
  return { look: 'side-edge', d };
}

const curveData = (curve: Curve): string =>
  piecesOf(curve)
    .map((piece) => pathData(piece, false))
    .join('');

type Draw = (view: View, frame: Frame) => readonly Shape[];

/** The shapes of each layer; later shapes are on top. */
const layers: Readonly<Record<Layer, Draw>> = {
  edges: ({ header, after }) => {
    const { curve = null, edges } = after.floatingHorizon ?? {};
    if (curve === null || edges === undefined) return [];
    const begun = header.scene.curves?.slice(0, curve + 1) ?? [];
    return [sideEdge(begun.map(first), edges.left), sideEdge(begun.map(last), edges.right)];
  },
  curve: (view, { scale }) => {
    const curve = currentCurve(view);
    if (curve === null) return [];
    const ends = view.after.floatingHorizon?.place.segment;
    const segment = curve.filter(hasPoint).filter(([x]) => ends?.includes(x));
    const [from, to] = [curve[0]?.[0] ?? 0, curve.at(-1)?.[0] ?? 0];
    const areApart = (to - from) * scale >= samplesApart * (curve.length - 1);
    const points = areApart ? piecesOf(curve).flat() : [];
    const samples = points.map((sample) => circleData(sample, 2 / scale)).join('');
    return [
      { look: 'current', d: curveData(curve) },
      { look: 'segment', d: pathData(segment, false) },
      { look: 'samples', d: samples },
    ];
  },
  lines: ({ lines }) => [{ look: 'visible', d: lines.map(lineData).join('') }],
  horizons: ({ columns, header: { scene, edition } }) => {
    if (columns === null) return [];
    const { horizons, before } = columns;
    const drawn = (look: string, heights: Heights): Shape => ({
      look,
      d: horizonData(heights, scene.area),
    });
    // The printed text compares with the horizons themselves.
    const compared = hasDefect(edition, 'x-h4')
      ? []
      : [drawn('upper before', before.upper), drawn('lower before', before.lower)];
    return [...compared, drawn('upper', horizons.upper), drawn('lower', horizons.lower)];
  },
  columns: (view, { scale }) => {
    const { columns, after, header } = view;
    const curve = currentCurve(view);
    const { area } = header.scene;
    const x = (after.floatingHorizon?.place.current ?? after.floatingHorizon?.place.previous)?.[0];
    if (columns === null || curve === null || x === undefined) return [];
    const r = Math.min(flagSize, 0.45 * scale) / scale;
    const data: Record<FlagLook, string> = { above: '', below: '', hidden: '', both: '' };
    for (let i = 0; i < area.width; i++) {
      const flag = columns.flags[i] ?? null;
      const y = flag === null ? null : heightOver(curve, area.x + i);
      if (flag === null || y === null) continue;
      const look = flagLooks[flag];
      data[look] += flagData[look]([area.x + i, y], r);
    }
    const column = { look: 'looked-at', d: columnData(x, area) };
    const marks = Object.entries(data).map(([look, d]) => ({ look: `flag ${look}`, d }));
    return [column, ...marks];
  },
};

type OfEvent<K extends keyof FloatingHorizonEvents> = (
  event: FloatingHorizonEvents[K],
  view: View,
  frame: Frame,
) => readonly Shape[];

const dotAt = (look: string, at: Spot, { scale }: Frame): Shape => ({
  look: `dot ${look}`,
  d: isShown(at) ? circleData(at, dot / scale) : '',
});

const heightDot: OfEvent<'raise' | 'lower' | 'height'> = ({ x, y }, _view, frame) => [
  dotAt('point', [x, toNumber(y)], frame),
];

/** The shapes of the step itself. */
const ofStep: { readonly [K in keyof FloatingHorizonEvents]?: OfEvent<K> } = {
  side_edge: ({ sample }, _view, frame) => [dotAt('point', sample, frame)],
  visibility: ({ x, flag }, view, frame) => {
    const y = heightOver(currentCurve(view) ?? [], x);
    return y === null ? [] : [dotAt(flag === 0 ? 'no' : 'yes', [x, y], frame)];
  },
  intersection: ({ point }, _view, frame) => [dotAt('point', spot(point), frame)],
  draw_line: ({ from, to }) => {
    const ends = [spot(from), spot(to)];
    if (!ends.every(isShown)) return [];
    const d = pathData(ends, false);
    return [
      { look: 'casing touched', d },
      { look: 'changed-part', d },
    ];
  },
  horizon: ({ upper, lower }, _view, { scale }) => {
    const bars = [...upper, ...lower].map(spot).filter(isShown);
    const reach = Math.max(0.3, 2 / scale);
    return [
      { look: 'changed-part', d: bars.map(([x, y]) => `M${x - reach} ${y}h${2 * reach}`).join('') },
    ];
  },
  height: heightDot,
  raise: heightDot,
  lower: heightDot,
  step: ({ x }, { header }) => [{ look: 'looked-at', d: columnData(x, header.scene.area) }],
};

const columnData = (x: number, { y, height }: Area): string => `M${x} ${y}v${height}`;

function stepShapes(event: Event, view: View, frame: Frame): readonly Shape[] {
  const draw = (ofStep as Readonly<Partial<Record<string, OfEvent<keyof FloatingHorizonEvents>>>>)[
    event.e
  ];
  return draw?.(event as FloatingHorizonEvents[keyof FloatingHorizonEvents], view, frame) ?? [];
}

/** The shapes of what is pointed at or asked about, anywhere on the page. */
function pointedShapes(view: View): readonly Shape[] {
  const { pointed, asked = [], header } = view;
  const { curves, area } = header.scene;
  return [...asked, ...(pointed === null ? [] : [pointed])].flatMap((text): readonly Shape[] => {
    const thing = thingOf(text, view);
    if (thing?.kind === 'curve') {
      return [{ look: 'pointed-curve', d: curveData(curves?.[thing.curve] ?? []) }];
    }
    return thing?.kind === 'column'
      ? [{ look: 'pointed-column', d: columnData(thing.x, area) }]
      : [];
  });
}

/** A column that is chosen or under the cursor. */
export const columnShape = (look: 'chosen-column' | 'cursor', x: number, area: Area): Shape => ({
  look,
  d: columnData(x, area),
});

const areaShape = ({ x, y, width, height }: Area): Shape => ({
  look: 'area',
  d: boxData([x, y, width, height]),
});

const above: readonly Layer[] = ['horizons', 'edges', 'curve', 'lines', 'columns'];

/** All shapes of a step; later shapes are on top. */
export function curveShapes(view: View, frame: Frame, shown: ReadonlySet<Layer>): readonly Shape[] {
  const { event, pixel, header } = view;
  const { area } = header.scene;
  const chosen = pixel === null ? [] : [columnShape('chosen-column', pixel[0], area)];
  return [
    areaShape(area),
    { look: 'rival', d: (view.rival ?? []).map(lineData).join('') },
    ...above.filter((layer) => shown.has(layer)).flatMap((layer) => layers[layer](view, frame)),
    ...(event === null ? [] : stepShapes(event, view, frame)),
    ...pointedShapes(view),
    ...chosen,
  ].filter(({ d }) => d !== '');
}

/** Invisible curves, wide enough to point at; empty if there are too many curves. */
export function curvesToPoint(curves: readonly Curve[]): readonly Shape[] {
  const most = 200;
  if (curves.length > most) return [];
  return curves.map((curve, i) => ({
    look: 'to-point',
    d: curveData(curve),
    thing: curveThing(i),
  }));
}

/** The picture of curves at a step with all layers, as a separate SVG document; see `figureOf`. */
export function figureOf(view: View): string {
  const frame = figureFrame(view);
  const shapes = curveShapes({ ...view, pointed: null, asked: [] }, frame, allLayers);
  return figureDocument(view, frame, shapes.map((shape) => pathOf(shape, frame.scale)).join(''));
}
