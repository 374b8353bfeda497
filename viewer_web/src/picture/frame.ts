import type { Sight } from '../state/quadtree.js';
import type { Area } from '../trace/header.js';
import type { Place } from './paint.js';
import type { Pixel } from './pixel.js';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** How much larger than the whole a part of the plane is shown, and the middle of that part. */
export interface Zoom {
  readonly by: number;
  readonly middle: Point;
}

/** Ways to another zoom. */
export type Zooming = 'out' | 'in' | 'whole';

export type Point = readonly [x: number, y: number];
type Rectangle = readonly [x: number, y: number, width: number, height: number];

/** CSS pixels that a pixel of the picture may always be enlarged to. */
const large = 64;
/** How much any picture may be enlarged. */
const most = 40;
/** CSS pixels that lines must be apart. */
const apart = 5;
/** What is around the area, as a part of its longer side. */
const margin = 0.07;

/** How the plane lies in a box of the page: the area and a margin around it, in the middle, or a part of that. */
export class Frame {
  /** The zoom that came of the one that was wanted; null where the whole is shown. */
  readonly zoom: Zoom | null;
  /** What of the plane fills the box. */
  readonly shown: Rectangle;
  /** The area and the margin around it. */
  readonly whole: Rectangle;
  /** CSS pixels per unit of the plane. */
  readonly scale: number;
  /** The same for the whole. */
  private readonly fit: number;

  constructor(
    readonly area: Area,
    readonly size: Size,
    readonly wanted: Zoom | null = null,
  ) {
    const { x, y, width, height } = area;
    const around = Math.max(width, height) * margin;
    this.whole = [x - around, y - around, width + 2 * around, height + 2 * around];
    const fit = Math.min(size.width / this.whole[2], size.height / this.whole[3]);
    this.fit = Math.max(fit, 1e-6);
    const by = this.limited(wanted?.by ?? 1);
    this.scale = this.fit * by;
    const seen: Point = [size.width / this.scale, size.height / this.scale];
    const middle: Point = [this.middleOf(0, seen), this.middleOf(1, seen)];
    this.shown = [middle[0] - seen[0] / 2, middle[1] - seen[1] / 2, ...seen];
    this.zoom = by > 1 ? { by, middle } : null;
  }

  get isLargest(): boolean {
    return (this.zoom?.by ?? 1) >= this.limited(Infinity);
  }

  /** What of it can be told apart. */
  get sight(): Sight {
    return { shown: this.shown, least: apart / this.scale };
  }

  private limited(by: number): number {
    return Math.min(Math.max(by, 1), Math.max(most, large / this.fit));
  }

  /** Nothing beyond the whole is shown, but where there is room for more: then the whole is in the middle. */
  private middleOf(axis: 0 | 1, seen: Point): number {
    const [from, length] =
      axis === 0 ? [this.whole[0], this.whole[2]] : [this.whole[1], this.whole[3]];
    const half = Math.min(seen[axis], length) / 2;
    const wanted = this.wanted?.middle[axis] ?? from + length / 2;
    return Math.min(Math.max(wanted, from + half), from + length - half);
  }

  /** The same plane and box with another zoom. */
  with(zoom: Zoom | null): Frame {
    return new Frame(this.area, this.size, zoom);
  }

  /** So much larger, with the same place under a point of the box. */
  zoomed(by: number, at: Point = this.center): Frame {
    const [x, y] = this.at(...at);
    const now = this.limited((this.zoom?.by ?? 1) * by);
    const scale = this.fit * now;
    const [left, top] = [at[0] - this.center[0], at[1] - this.center[1]];
    return this.with({ by: now, middle: [x - left / scale, y - top / scale] });
  }

  /** What is shown moves by so many CSS pixels. */
  moved(dx: number, dy: number): Frame {
    const [x, y] = this.middle;
    const { by } = this.zoom ?? { by: 1 };
    return this.with({ by, middle: [x - dx / this.scale, y - dy / this.scale] });
  }

  /** Moved no more than it must be to show a square of the plane, with as much again around it. */
  showing([x, y]: Point, side: number): Frame {
    const [left, top, width, height] = this.shown;
    const along = (from: number, seen: number, at: number): number => {
      const room = Math.min(side, (seen - side) / 2);
      return Math.min(at - room - from, 0) + Math.max(at + side + room - from - seen, 0);
    };
    const { scale } = this;
    return this.moved(-along(left, width, x) * scale, -along(top, height, y) * scale);
  }

  /** Where the area lies on a canvas with so many dots per CSS pixel. */
  place(ratio: number): Place {
    const { area, shown, scale } = this;
    const dots = scale * ratio;
    return { x: (area.x - shown[0]) * dots, y: (area.y - shown[1]) * dots, scale: dots, ratio };
  }

  private get center(): Point {
    return [this.size.width / 2, this.size.height / 2];
  }

  /** The middle of what is shown. */
  get middle(): Point {
    return this.at(...this.center);
  }

  /** What of the plane is under a point of the box. */
  at(x: number, y: number): Point {
    const { shown, scale } = this;
    return [shown[0] + x / scale, shown[1] + y / scale];
  }

  /** The pixel of the plane under a point of the box. */
  pixelAt(x: number, y: number): Pixel {
    const [across, down] = this.at(x, y);
    return [Math.floor(across), Math.floor(down)];
  }
}
