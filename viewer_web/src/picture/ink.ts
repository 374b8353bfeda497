import type { Frame, Size } from './frame.js';
import { lookOf } from './looks.js';
import type { Shape } from './shapes.js';

/** The pen that draws a look on a canvas; lengths are in CSS pixels. */
interface Pen {
  readonly fill: string | null;
  readonly fillOpacity: number;
  readonly stroke: string | null;
  readonly strokeOpacity: number;
  readonly width: number;
  readonly dashes: readonly number[];
  readonly join: CanvasLineJoin;
  readonly cap: CanvasLineCap;
}

const pens = new Map<string, Pen>();

function penOf(look: string): Pen {
  const known = pens.get(look);
  if (known !== undefined) return known;
  const attributes = lookOf(look, 1);
  const color = (name: string): string | null => {
    const value = attributes.get(name) ?? 'none';
    return value === 'none' ? null : value;
  };
  const number = (name: string): number => Number.parseFloat(attributes.get(name) ?? '1');
  const pen: Pen = {
    fill: color('fill'),
    fillOpacity: number('fill-opacity'),
    stroke: color('stroke'),
    strokeOpacity: number('stroke-opacity'),
    width: number('stroke-width'),
    dashes: (attributes.get('stroke-dasharray') ?? '').split(' ').filter(Boolean).map(Number),
    join: (attributes.get('stroke-linejoin') ?? 'miter') as CanvasLineJoin,
    cap: (attributes.get('stroke-linecap') ?? 'butt') as CanvasLineCap,
  };
  pens.set(look, pen);
  return pen;
}

/** Makes a canvas fill a box of the page at the device's resolution. Its content is lost only if its size changes. */
export function fit(canvas: HTMLCanvasElement, { width, height }: Size, ratio: number): void {
  const across = Math.ceil(width * ratio);
  const down = Math.ceil(height * ratio);
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  const [wide, high] = [`${across / ratio}px`, `${down / ratio}px`];
  if (canvas.style.width !== wide) canvas.style.width = wide;
  if (canvas.style.height !== high) canvas.style.height = high;
}

/** What a canvas shows. */
interface Inked {
  readonly shapes: readonly Shape[];
  readonly frame: Frame;
  readonly ratio: number;
}

const areAlike = (some: readonly Shape[], others: readonly Shape[]): boolean =>
  some === others ||
  (some.length === others.length &&
    some.every(({ look, d, color, fill }, i) => {
      const other = others[i];
      return other?.d === d && other.look === look && other.color === color && other.fill === fill;
    }));

/**
 * Draws shapes on a canvas as an SVG document would show them. Shapes that the canvas already shows are not drawn again.
 */
export class Inker {
  private last: Inked | null = null;

  /** Draws on a canvas that fills the frame's box, with `ratio` canvas pixels per CSS pixel. */
  draw(canvas: HTMLCanvasElement, shapes: readonly Shape[], frame: Frame, ratio: number): void {
    const context = canvas.getContext('2d');
    const { last } = this;
    const isSame = last?.frame === frame && last.ratio === ratio && areAlike(last.shapes, shapes);
    if (context === null || isSame) return;
    this.last = { shapes, frame, ratio };
    const { shown, scale } = frame;
    context.resetTransform();
    context.clearRect(0, 0, canvas.width, canvas.height);
    const dots = scale * ratio;
    context.setTransform(dots, 0, 0, dots, -shown[0] * dots, -shown[1] * dots);
    let d = '';
    let path = new Path2D();
    for (const shape of shapes) {
      // A line and the casing under it have the same path.
      if (shape.d !== d) {
        d = shape.d;
        path = new Path2D(d);
      }
      draw(context, path, shape, scale);
    }
  }
}

function draw(
  context: CanvasRenderingContext2D,
  path: Path2D,
  { look, color, fill }: Shape,
  scale: number,
): void {
  const pen = penOf(look);
  const inner = fill ?? pen.fill;
  if (inner !== null) {
    context.globalAlpha = pen.fillOpacity;
    context.fillStyle = inner;
    context.fill(path);
  }
  const line = color ?? pen.stroke;
  if (line === null) return;
  context.globalAlpha = pen.strokeOpacity;
  context.strokeStyle = line;
  context.lineWidth = pen.width / scale;
  context.lineJoin = pen.join;
  context.lineCap = pen.cap;
  context.setLineDash(pen.dashes.map((length) => length / scale));
  context.stroke(path);
}
