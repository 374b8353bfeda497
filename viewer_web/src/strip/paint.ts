import { algorithmOf } from '../algorithm/algorithm.js';
import { columnsOf, placeOf } from '../time/columns.js';
import type { Column, Depth } from '../time/columns.js';
import { cases } from '../time/course.js';
import type { Course } from '../time/course.js';
import type { Range } from '../time/range.js';
import { lanesOf, marksHeight, stripHeight } from './lanes.js';
import type { Lane, LaneName, Lanes } from './lanes.js';
import type { Look } from './look.js';
import { stripes } from './look.js';

/** A lane in dots of the canvas. */
interface Band {
  readonly top: number;
  readonly height: number;
}

type Painter = (band: Band) => void;

/** Paints a part of a run as a strip, once for each part, size and theme. */
export class StripPainter {
  private readonly columns: readonly Column[];
  private readonly fills = new Map<number, CanvasPattern | string>();

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly course: Course,
    private readonly look: Look,
    private readonly range: Range,
  ) {
    this.columns = columnsOf(course, context.canvas.width, range);
  }

  paint(): void {
    const { context } = this;
    context.clearRect(0, 0, context.canvas.width, context.canvas.height);
    for (const lane of lanesOf(this.course.trace.header)) {
      const band = this.bandOf(lane);
      context.fillStyle = this.look.ground;
      context.fillRect(0, band.top, context.canvas.width, band.height);
      this.painters[lane.name](band);
    }
    this.marks();
  }

  /** Paints only the current item, over the whole height. */
  paintBare(): void {
    this.context.clearRect(0, 0, this.context.canvas.width, this.context.canvas.height);
    this.shares(this.bandOf({ top: 0, height: stripHeight }));
  }

  private bandOf({ top, height }: Omit<Lane, 'name'>): Band {
    const { ratio } = this.look;
    const first = Math.round(top * ratio);
    return { top: first, height: Math.round((top + height) * ratio) - first };
  }

  private readonly painters: Readonly<Record<LaneName, Painter>> = {
    cases: (band) => this.shares(band),
    polygons: (band) => {
      this.shares(band);
      this.names(band);
    },
    curves: (band) => {
      this.shares(band);
      this.names(band);
    },
    levels: (band) => {
      this.depths(band, this.look.level, this.course.finest, ({ levels }) => levels);
    },
    calls: (band) => {
      this.depths(band, this.look.call, this.course.deepest, ({ calls }) => calls);
    },
    ael: ({ top, height }) => {
      this.context.fillStyle = this.look.ink;
      this.columns.forEach(({ ael }, x) => {
        if (ael) this.context.fillRect(x, top, Math.max(1, this.look.ratio), height);
      });
    },
  };

  /** Each part is as tall as its share of the steps, but at least one dot. */
  private shares({ top, height }: Band): void {
    this.columns.forEach(({ first, end, shares }, x) => {
      let y = top;
      const steps = end - first;
      const bottom =
        top + Math.round((height * shares.reduce((sum, s) => sum + s.steps, 0)) / steps);
      shares.forEach((share, i) => {
        const left = shares.length - 1 - i;
        const tall = Math.max(1, Math.round((height * share.steps) / steps));
        const until = left === 0 ? bottom : Math.min(y + tall, bottom - left);
        this.context.fillStyle = this.fillOf(share.part);
        if (until > y) this.context.fillRect(x, y, 1, until - y);
        y = Math.max(y, until);
      });
    });
  }

  private fillOf(part: number): CanvasPattern | string {
    const known = this.fills.get(part);
    if (known !== undefined) return known;
    const { header } = this.course.trace;
    const { scene } = header;
    const { look } = this;
    const name = cases[part];
    const polygon = scene.polygons[part];
    // Making stripes for each of thousands of polygons takes seconds.
    const isCrowd = scene.polygons.length * stripes * look.ratio > this.columns.length;
    const ofPolygon = (): CanvasPattern | string => {
      if (polygon === undefined) return look.ground;
      return isCrowd ? polygon.color : look.ofPolygon(polygon, part);
    };
    const fills: Readonly<Record<Lanes['first'], () => CanvasPattern | string>> = {
      cases: () => (name === undefined ? look.ground : look.ofCase(name)),
      polygons: ofPolygon,
      curves: () => look.ofCurve(part),
    };
    const fill = fills[algorithmOf(header).lanes.first]();
    this.fills.set(part, fill);
    return fill;
  }

  /** The polygons' ids or the curves' numbers, where there is room, each after a line. */
  private names({ top, height }: Band): void {
    const { context, course, look } = this;
    const { polygons, curves } = course.trace.header.scene;
    const { ratio } = look;
    const whole = this.columns.length;
    context.font = look.font;
    context.textBaseline = 'middle';
    const { first: firsts, part } = course.stretches;
    firsts.forEach((first, i) => {
      const next = firsts[i + 1] ?? course.length + 1;
      const from = Math.round(Math.max(0, placeOf(first - 0.5, this.range, whole)));
      const until = Math.min(whole, placeOf(next - 0.5, this.range, whole));
      const room = until - from - 10 * ratio;
      if (room < 6 * ratio || (part[i] ?? -1) < 0) return;
      const id = curves === null ? (polygons[part[i] ?? -1]?.id ?? '') : String(part[i] ?? '');
      const { width } = context.measureText(id);
      context.fillStyle = look.ink;
      context.fillRect(from, top, Math.max(1, ratio), height);
      if (width > room) return;
      context.fillStyle = look.ground;
      context.fillRect(from + 3 * ratio, top + 2 * ratio, width + 4 * ratio, height - 4 * ratio);
      context.fillStyle = look.ink;
      context.fillText(id, from + 5 * ratio, top + height / 2 + ratio / 2);
    });
  }

  /** Pale up to the greatest depth of the column's steps, dark up to their mean depth. */
  private depths(
    { top, height }: Band,
    color: string,
    greatest: number,
    of: (column: Column) => Depth,
  ): void {
    const { context } = this;
    context.fillStyle = color;
    this.columns.forEach((column, x) => {
      const { mean, most } = of(column);
      for (const [depth, alpha] of [
        [most, 0.4],
        [mean, 1],
      ] as const) {
        const tall = Math.round((height * depth) / greatest);
        context.globalAlpha = alpha;
        context.fillRect(x, top + height - tall, 1, tall);
      }
    });
    context.globalAlpha = 1;
  }

  /** A rare mark is wider than its column, so that it is visible. */
  private marks(): void {
    const { context, look } = this;
    const { top, height } = this.bandOf({ top: 0, height: marksHeight - 2 });
    this.columns.forEach(({ wrong, fault }, x) => {
      if (wrong) wrongMark(context, x + 0.5, top, height, look);
      if (fault) faultMark(context, x + 0.5, top, height, look);
    });
  }
}

type MarkPainter = (
  context: CanvasRenderingContext2D,
  x: number,
  top: number,
  height: number,
  look: Pick<Look, 'ratio' | 'wrong' | 'ink'>,
) => void;

/** A wedge that points at its column. */
export const wrongMark: MarkPainter = (context, x, top, height, { ratio, wrong }) => {
  context.fillStyle = wrong;
  context.beginPath();
  context.moveTo(x - 3 * ratio, top);
  context.lineTo(x + 3 * ratio, top);
  context.lineTo(x, top + height);
  context.fill();
};

/** A line. */
export const hitMark = (
  context: CanvasRenderingContext2D,
  x: number,
  top: number,
  height: number,
  { ratio, hit }: { readonly ratio: number; readonly hit: string },
): void => {
  context.fillStyle = hit;
  context.fillRect(x, top, Math.max(1, Math.round(1.5 * ratio)), height);
};

/** A cross. */
export const faultMark: MarkPainter = (context, x, top, height, { ratio, ink }) => {
  const half = height / 2 - ratio / 2;
  const y = top + height / 2;
  context.strokeStyle = ink;
  context.lineWidth = 2 * ratio;
  context.beginPath();
  context.moveTo(x - half, y - half);
  context.lineTo(x + half, y + half);
  context.moveTo(x - half, y + half);
  context.lineTo(x + half, y - half);
  context.stroke();
};
