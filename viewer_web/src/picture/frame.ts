import type { Sight } from '../replay/screen.js';
import type { Area } from '../trace/header.js';
import type { Place } from './paint.js';
import type { Pixel } from './pixel.js';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** The magnification of a visible part of the plane relative to the whole, and the centre of that part. */
export interface Zoom {
  readonly by: number;
  readonly middle: Point;
}

/** The zoom commands; `all` also shows what lies outside the area. */
export type Zooming = 'out' | 'in' | 'whole' | 'all';

export type Point = readonly [x: number, y: number];
export type Rectangle = readonly [x: number, y: number, width: number, height: number];

/** A pixel of the picture can always be enlarged to this number of CSS pixels. */
const large = 64;
/** Any picture can be magnified this many times. */
const most = 40;
/** The least distance between lines, in CSS pixels. */
const apart = 5;
/** CSS pixels around everything that the view can reach: the zoom buttons lie there, and knobs of vertices are whole. */
const controls = 44;
/** The view goes no farther than this many times the longer side of the area: numbers of pixels would overflow there. */
const farthest = 1e6;
/** The margin around the area as a share of its longer side. */
const usualMargin = 0.07;

/** The margin in a box: less in a small one, unless the numbers of rows need it for more than two digits. */
export function marginIn({ width, height }: Size, area: Area): number {
  const digits = Math.max(...[area.y, area.y + area.height - 1].map((row) => String(row).length));
  return Math.min(width, height) < 420 && digits <= 2 ? 0.05 : usualMargin;
}

/** The position of the plane in a box of the page: the area and a margin around it, centred, or a part of that. */
export class Frame {
  /** The actual zoom, limited from the wanted one; null if the whole is shown. */
  readonly zoom: Zoom | null;
  /** The part of the plane that fills the box. */
  readonly shown: Rectangle;
  /** The area and the margin around it. */
  readonly whole: Rectangle;
  /** The region that the view can move in: the whole, extended on all sides as far as the scene reaches. */
  private readonly bounds: Rectangle;
  /** CSS pixels per unit of the plane. */
  readonly scale: number;
  /** The scale at which the whole fills the box. */
  private readonly fit: number;
  /** The least magnification, at which everything is visible: 1 or less. */
  private readonly least: number;

  constructor(
    readonly area: Area,
    readonly size: Size,
    readonly wanted: Zoom | null = null,
    /** The extent of the scene. */
    readonly extent: Rectangle = [area.x, area.y, area.width, area.height],
    readonly margin = usualMargin,
  ) {
    const { x, y, width, height } = area;
    const border = Math.max(width, height) * margin;
    this.whole = around([x, y, width, height], [border, border]);
    const far = farthest * Math.max(width, height);
    const reach: Point = [
      Math.min(farther(extent, this.whole, 0), far),
      Math.min(farther(extent, this.whole, 1), far),
    ];
    const isWhole = reach[0] === 0 && reach[1] === 0;
    const fit = ([, , across, down]: Rectangle, room = 0): number =>
      Math.max(Math.min((size.width - 2 * room) / across, (size.height - 2 * room) / down), 1e-6);
    const reached = around(this.whole, reach);
    const room = Math.min(controls, size.width / 4, size.height / 4);
    const beyond = room / fit(reached, room);
    this.bounds = isWhole ? this.whole : around(reached, [beyond, beyond]);
    this.fit = fit(this.whole);
    this.least = Math.min(1, fit(this.bounds) / this.fit);
    const by = this.limited(wanted?.by ?? 1);
    this.scale = this.fit * by;
    const seen: Point = [size.width / this.scale, size.height / this.scale];
    const middle: Point = [this.middleOf(0, seen), this.middleOf(1, seen)];
    this.shown = [middle[0] - seen[0] / 2, middle[1] - seen[1] / 2, ...seen];
    this.zoom = by === 1 ? null : { by, middle };
  }

  /** Whether there is anything outside the whole. */
  get hasMore(): boolean {
    return this.least < 1;
  }

  /** The zoom at which that is visible, too. */
  get all(): Zoom | null {
    return this.hasMore ? { by: this.least, middle: this.middleOfWhole } : null;
  }

  get isSmallest(): boolean {
    return (this.zoom?.by ?? 1) <= this.least;
  }

  get isLargest(): boolean {
    return (this.zoom?.by ?? 1) >= this.limited(Infinity);
  }

  /** The visible part, and the smallest distinguishable size. */
  get sight(): Sight {
    return { shown: this.shown, least: apart / this.scale };
  }

  private limited(by: number): number {
    return Math.min(Math.max(by, this.least), Math.max(most, large / this.fit));
  }

  private get middleOfWhole(): Point {
    const [left, top, width, height] = this.whole;
    return [left + width / 2, top + height / 2];
  }

  /** The centre of the view along an axis. The view stays within the bounds; if it is larger, they are centred. */
  private middleOf(axis: 0 | 1, seen: Point): number {
    const { bounds } = this;
    const [from, length] = axis === 0 ? [bounds[0], bounds[2]] : [bounds[1], bounds[3]];
    const half = Math.min(seen[axis], length) / 2;
    const { by, middle } = this.wanted ?? { by: 1, middle: this.middleOfWhole };
    const wanted = (by === 1 ? this.middleOfWhole : middle)[axis];
    return Math.min(Math.max(wanted, from + half), from + length - half);
  }

  /** This plane and box with another zoom. */
  with(zoom: Zoom | null): Frame {
    return new Frame(this.area, this.size, zoom, this.extent, this.margin);
  }

  /** Magnifies by a factor and keeps the place under a point of the box. A zoom that would pass the whole stops there. */
  zoomed(by: number, at: Point = this.center): Frame {
    const [x, y] = this.at(...at);
    const old = this.zoom?.by ?? 1;
    const isPast = (old - 1) * (old * by - 1) < 0;
    const now = isPast ? 1 : this.limited(old * by);
    const scale = this.fit * now;
    const [left, top] = [at[0] - this.center[0], at[1] - this.center[1]];
    return this.with({ by: now, middle: [x - left / scale, y - top / scale] });
  }

  /** Moves the plane by a number of CSS pixels. */
  moved(dx: number, dy: number): Frame {
    const [x, y] = this.middle;
    const { by } = this.zoom ?? { by: 1 };
    return this.with({ by, middle: [x - dx / this.scale, y - dy / this.scale] });
  }

  /** Moves the plane only as far as needed to show a square with a margin of its own size. */
  showing([x, y]: Point, side: number): Frame {
    const [left, top, width, height] = this.shown;
    const along = (from: number, seen: number, at: number): number => {
      const room = Math.min(side, (seen - side) / 2);
      return Math.min(at - room - from, 0) + Math.max(at + side + room - from - seen, 0);
    };
    const { scale } = this;
    return this.moved(-along(left, width, x) * scale, -along(top, height, y) * scale);
  }

  /** The position of the area on a canvas with `ratio` canvas pixels per CSS pixel. */
  place(ratio: number): Place {
    const { area, shown, scale } = this;
    const dots = scale * ratio;
    return { x: (area.x - shown[0]) * dots, y: (area.y - shown[1]) * dots, scale: dots, ratio };
  }

  private get center(): Point {
    return [this.size.width / 2, this.size.height / 2];
  }

  /** The centre of the visible part. */
  get middle(): Point {
    return this.at(...this.center);
  }

  /** The point of the plane under a point of the box. */
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

const around = ([x, y, width, height]: Rectangle, [across, down]: Point): Rectangle => [
  x - across,
  y - down,
  width + 2 * across,
  height + 2 * down,
];

/** The greater of the two distances by which one rectangle extends beyond another along an axis. */
function farther(one: Rectangle, other: Rectangle, axis: 0 | 1): number {
  const size = axis === 0 ? 2 : 3;
  const before = other[axis] - one[axis];
  const after = one[axis] + one[size] - other[axis] - other[size];
  return Math.max(before, after, 0);
}
