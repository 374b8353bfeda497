import { cutsAnywhere } from '../trace/editions.js';
import type { Header, Polygon, Scene } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Box, N } from '../trace/values.js';
import { cut, pieces } from './cuts.js';
import { Grid, toGround, toPixel } from './grid.js';
import type { Row } from './grid.js';
import { halve, leaves } from './quadtree.js';
import type { Sight } from './quadtree.js';

/** Pixels of an area whose depths are kept: those of a larger one fill the memory of a browser. */
const mostDepths = 2 ** 24;

export const hasRoomForDepths = ({ area: { width, height } }: Scene): boolean =>
  width * height <= mostDepths;

/** Whether the state has the depths that a trace tells. */
export const keepsDepths = ({ detail, scene }: Pick<Header, 'detail' | 'scene'>): boolean =>
  detail !== 'windows' && hasRoomForDepths(scene);

/** Windows, and what they were found in. */
interface Divided {
  readonly of: readonly unknown[];
  readonly windows: readonly Box[];
}

/**
 * What the handlers of events write to: the picture, how the area is divided into windows and, where the trace carries
 * it, the buffer of depths.
 */
export class Screen {
  /** Pixels; where nothing was painted yet those of the ground. */
  readonly picture: Grid<number>;
  /**
   * For each pixel, of the smallest window that it is in: how often the first one was halved to get it; where windows are
   * cut anywhere, which of its sides are there.
   */
  readonly division: Grid<number>;
  z: Grid<N> | null = null;
  /** The windows that were asked for last. */
  private divided: Divided | null = null;
  private places: ReadonlyMap<string, number> | null = null;

  constructor(
    readonly scene: Scene,
    private readonly hasDepths: boolean,
    readonly isCut = false,
  ) {
    const { width, height } = scene.area;
    const ground = toGround(scene.background);
    this.picture = new Grid<number>(width, height, ground, (n) => new Uint32Array(n));
    this.division = new Grid<number>(width, height, 0, (n) => new Uint8Array(n));
  }

  polygon(id: string): Polygon {
    const polygon = this.scene.byId.get(id);
    if (polygon === undefined) throw new Refusal('polygon', 'noSuchPolygon', id);
    return polygon;
  }

  /** A polygon's place in the scene. */
  placeOf(id: string): number {
    this.places ??= new Map(this.scene.polygons.map((polygon, i) => [polygon.id, i]));
    return this.places.get(id) ?? -1;
  }

  /** Pixels of the plane take a colour; they must lie in the area. */
  paint(x: number, y: number, width: number, height: number, color: string): void {
    this.expectInside(x, y, width, height);
    const { area } = this.scene;
    this.picture.fill(x - area.x, y - area.y, width, height, toPixel(color));
  }

  protected expectInside(x: number, y: number, width: number, height: number): void {
    const { area } = this.scene;
    const i = x - area.x;
    const j = y - area.y;
    const inside = i >= 0 && j >= 0 && width >= 0 && height >= 0;
    if (!inside || i + width > area.width || j + height > area.height) {
      throw new Refusal('', 'outsideArea');
    }
  }

  /** The pixels whose centres lie in a window, a part of the first one, are in no smaller one. */
  divide(window: Box, root: Box): void {
    const { area } = this.scene;
    if (!this.isCut) halve(this.division, area, window, root);
    else {
      this.expectCut(window);
      cut(this.division, area, window);
    }
  }

  /** A window that is cut anywhere has whole pixels. */
  protected expectCut([x, y, width, height]: Box): void {
    if (![x, y, width, height].every(Number.isInteger)) throw new Refusal('window', 'outsideArea');
    this.expectInside(x, y, width, height);
  }

  /** The windows that the area is divided into, as far as they can be told apart: the same list until one is divided. */
  windows(root: Box, sight: Sight): readonly Box[] {
    const { division, divided, isCut } = this;
    const { area } = this.scene;
    const { version } = division;
    const of = [version, root, sight.shown, sight.least] as const;
    if (divided?.of.every((each, i) => each === of[i]) === true) return divided.windows;
    const windows = isCut ? pieces(division, area, sight) : leaves(division, root, area, sight);
    this.divided = { of, windows };
    return windows;
  }

  clear(color: string, z: N): void {
    const { width, height } = this.scene.area;
    this.picture.fill(0, 0, width, height, toGround(color));
    if (this.hasDepths) this.z = this.depths(z);
  }

  save(): SavedScreen {
    const { picture, division, z } = this;
    return { picture: picture.save(), division: division.save(), z: z?.save() ?? null };
  }

  load({ picture, division, z }: SavedScreen): void {
    this.picture.load(picture);
    this.division.load(division);
    if (z === null) this.z = null;
    else (this.z ??= this.depths('-inf')).load(z);
  }

  private depths(z: N): Grid<N> {
    const { width, height } = this.scene.area;
    return new Grid<N>(width, height, z, (n) => new Array<N>(n).fill(z));
  }
}

/** What only says whether something can be painted. */
export class Bounds extends Screen {
  constructor(header: Header) {
    super(header.scene, false, cutsAnywhere(header.method));
  }

  override paint(x: number, y: number, width: number, height: number): void {
    this.expectInside(x, y, width, height);
  }

  override divide(window: Box): void {
    if (this.isCut) this.expectCut(window);
  }

  override clear(): void {
    // Nothing is painted.
  }
}

export interface SavedScreen {
  readonly picture: readonly Row<number>[];
  readonly division: readonly Row<number>[];
  readonly z: readonly Row<N>[] | null;
}
