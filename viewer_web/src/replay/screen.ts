import type { N } from '../trace/event-table.js';
import type { Header, Scene } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import { engine } from './engine.js';

/** A colour `#rrggbb` as the four bytes of a canvas pixel. */
export function toPixel(color: string): number {
  const rgb = Number.parseInt(color.slice(1), 16);
  return (0xff000000 | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** An unpainted pixel has the background colour with alpha 0. */
export const isPainted = (pixel: number): boolean => pixel >>> 24 !== 0;

export function toColor(pixel: number): string {
  const rgb = ((pixel & 0xff) << 16) | (pixel & 0xff00) | ((pixel >> 16) & 0xff);
  return `#${rgb.toString(16).padStart(6, '0')}`;
}

/** The most pixels of an area whose depths the library keeps. */
const mostDepths = 2 ** 24;

/** Whether the steps of a run have depths: the trace must contain them, and the area must not be too large. */
export const keepsDepths = ({
  detail,
  scene: { area },
}: Pick<Header, 'detail' | 'scene'>): boolean =>
  detail !== 'windows' && area.width * area.height <= mostDepths;

/** The visible part of the plane, and the size that a window must have to be distinguishable. */
export interface Sight {
  readonly shown: readonly [x: number, y: number, width: number, height: number];
  readonly least: number;
}

/** The pixels after a step, as a canvas has them. An unpainted one has the background colour with alpha 0. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** A number that differs whenever the pixels may differ. */
  readonly version: string;
  at(i: number, j: number): number;
  row(j: number): Uint32Array;
  /** Whether a row is equal to the one above it. */
  repeats(j: number): boolean;
}

/** The depths after a step. */
interface Depths {
  /** To the nearest ordinary number. */
  near(i: number, j: number): number;
  at(i: number, j: number): N;
}

/** The windows of a run that were asked for last, and what they depend on. */
export interface Division {
  of: string;
  windows: readonly Box[];
}

/** What the events up to a step have written to the area; the library shows one step at a time. */
export class Screen {
  readonly picture: Pixels;

  constructor(
    private readonly header: Header,
    private readonly trace: number,
    /** Makes the library show this step. */
    private readonly show: () => void,
    private readonly division: Division,
  ) {
    const { x, y, width, height } = header.scene.area;
    const { exports } = engine();
    this.picture = {
      width,
      height,
      get version() {
        show();
        return `${trace} ${exports.painted_at(trace)}`;
      },
      at(i, j) {
        show();
        return exports.pixel(trace, x + i, y + j) >>> 0;
      },
      row(j) {
        show();
        const at = exports.pixel_rows(trace, y + j, 1);
        return new Uint32Array(exports.memory.buffer.slice(at, at + 4 * width));
      },
      repeats(j) {
        show();
        return j > 0 && exports.row_repeats(trace, y + j) !== 0;
      },
    };
  }

  get scene(): Scene {
    return this.header.scene;
  }

  /** Whether pixels that nothing has painted are background, and not merely unpainted so far. */
  get isGround(): boolean {
    this.show();
    return engine().exports.is_ground(this.trace) !== 0;
  }

  /** The step that painted a pixel of the plane last; 0 if none has. */
  painter(x: number, y: number): number {
    this.show();
    return engine().exports.painter(this.trace, x, y);
  }

  /** The depths of the Z-buffer; null without them. */
  get z(): Depths | null {
    const { trace, show } = this;
    const { x, y } = this.scene.area;
    show();
    if (engine().exports.has_depths(trace) === 0) return null;
    return {
      near(i, j) {
        show();
        return engine().exports.depth(trace, x + i, y + j);
      },
      at(i, j) {
        show();
        engine().exports.depth_text(trace, x + i, y + j);
        return JSON.parse(engine().made()) as N;
      },
    };
  }

  /** The windows into which the area is divided, as far as they are distinguishable: the same list until one is divided. */
  windows({ shown: [x, y, width, height], least }: Sight): readonly Box[] {
    this.show();
    const { exports } = engine();
    const [left, top] = [Math.floor(x), Math.floor(y)];
    const size = [Math.ceil(x + width) - left, Math.ceil(y + height) - top] as const;
    const of = [exports.divided_at(this.trace), left, top, ...size, least].join(' ');
    if (this.division.of !== of) {
      this.division.windows = boxesAt(exports.windows(this.trace, left, top, ...size, least));
      this.division.of = of;
    }
    return this.division.windows;
  }
}

/** Windows in the library's memory: their number, and four numbers each. */
function boxesAt(at: number): readonly Box[] {
  const { buffer } = engine().exports.memory;
  const count = new Float64Array(buffer, at, 1)[0] ?? 0;
  const sides = new Float64Array(buffer, at + 8, 4 * count);
  return Array.from({ length: count }, (_, i) => {
    const [x = 0, y = 0, width = 0, height = 0] = sides.subarray(4 * i);
    return [x, y, width, height];
  });
}
