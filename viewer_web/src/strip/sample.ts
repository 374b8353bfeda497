import type { StripMark } from '../language/texts.js';
import type { Case } from '../time/course.js';
import { flag } from './lanes.js';
import type { LaneName } from './lanes.js';
import type { Look } from './look.js';
import { faultMark, hitMark, wrongMark } from './paint.js';

/** The entries of the strip's legend that have a sample. */
export type Sample = Case | Exclude<LaneName, 'cases'> | StripMark;

type SamplePainter = (context: CanvasRenderingContext2D, look: Look) => void;

/** Bars of several heights, as depths are shown. */
function bars(context: CanvasRenderingContext2D, ratio: number): void {
  const bar = (left: number, top: number, alpha: number): void => {
    context.globalAlpha = alpha;
    context.fillRect(left * ratio, top * ratio, 8 * ratio, (14 - top) * ratio);
  };
  bar(2, 9, 1);
  bar(10, 2, 0.4);
  bar(10, 6, 1);
  bar(18, 4, 1);
}

const painters: Readonly<Record<Exclude<Sample, Case>, SamplePainter>> = {
  polygons: (context, { ofPolygon }) => {
    const { width, height } = context.canvas;
    const gray = { id: '', color: '#7d8899', vertices: [] };
    context.fillStyle = ofPolygon(gray, 0);
    context.fillRect(0, 0, width / 2, height);
    context.fillStyle = ofPolygon(gray, 1);
    context.fillRect(width / 2, 0, width / 2, height);
  },
  curves: (context, { ofCurve }) => {
    const { width, height } = context.canvas;
    context.fillStyle = ofCurve(0);
    context.fillRect(0, 0, width / 2, height);
    context.fillStyle = ofCurve(1);
    context.fillRect(width / 2, 0, width / 2, height);
  },
  levels: (context, { level, ratio }) => {
    context.fillStyle = level;
    bars(context, ratio);
  },
  calls: (context, { call, ratio }) => {
    context.fillStyle = call;
    bars(context, ratio);
  },
  ael: (context, { ink, ratio }) => {
    context.fillStyle = ink;
    for (const x of [5, 9, 20]) context.fillRect(x * ratio, 3 * ratio, ratio, 11 * ratio);
  },
  wrong: (context, look) => {
    wrongMark(context, 14 * look.ratio, 3 * look.ratio, 8 * look.ratio, look);
  },
  fault: (context, look) => {
    faultMark(context, 14 * look.ratio, 3 * look.ratio, 8 * look.ratio, look);
  },
  hit: (context, look) => {
    for (const x of [6, 9, 20])
      hitMark(context, x * look.ratio, 3 * look.ratio, 8 * look.ratio, look);
  },
  bookmark: (context, { bookmark, ratio }) => {
    context.fillStyle = bookmark;
    context.setTransform(ratio, 0, 0, ratio, 10 * ratio, ratio);
    context.fill(new Path2D(flag(12)));
    context.resetTransform();
  },
  now: (context, { ink, ratio }) => {
    context.fillStyle = ink;
    context.fillRect(13 * ratio, 0, 2 * ratio, 14 * ratio);
  },
};

/** Paints a sample of 28 by 14 CSS pixels in the way of the strip. */
export function paintSample(context: CanvasRenderingContext2D, of: Sample, look: Look): void {
  if (of in painters) painters[of as keyof typeof painters](context, look);
  else {
    context.fillStyle = look.ofCase(of as Case);
    context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  }
}
