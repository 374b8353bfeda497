import { cutsAnywhere } from '../trace/editions.js';
import type { Header, Polygon, Scene } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Box, N } from '../trace/values.js';
import { cut, pieces } from './cuts.js';
import { Grid, toGround, toPixel } from './grid.js';
import type { Row } from './grid.js';
import { halve, leaves } from './quadtree.js';
import type { Sight } from './quadtree.js';

/** The most pixels of an area with stored depths: more would fill the memory of a browser. */
const mostDepths = 2 ** 24;

export const hasRoomForDepths = ({ area: { width, height } }: Scene): boolean =>
  width * height <= mostDepths;

/** Whether the state has depths: the trace must contain them, and the area must not be too large. */
export const keepsDepths = ({ detail, scene }: Pick<Header, 'detail' | 'scene'>): boolean =>
  detail !== 'windows' && hasRoomForDepths(scene);

/** Windows, and the values that they were computed from. */
interface Divided {
  readonly of: readonly unknown[];
  readonly windows: readonly Box[];
}

/**
 * What the handlers of events write to: the picture, the division of the area into windows, and the depth buffer if the
 * trace has one.
 */
export class Screen {
  /** The pixels; unpainted ones have the background colour with alpha 0. */
  readonly picture: Grid<number>;
  /**
   * For each pixel, the number of halvings from the first window to its smallest window. Where windows are cut anywhere,
   * the sides of that window at the pixel.
   */
  readonly division: Grid<number>;
  /** The step that painted each pixel last; 0 for unpainted ones. */
  readonly painters: Grid<number>;
  z: Grid<N> | null = null;
  /** Whether pixels that nothing has painted are background, and not merely unpainted so far. */
  isGround = false;
  /** The step of the event that writes now. */
  step = 0;
  /** The windows that were requested last. */
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
    this.painters = new Grid<number>(width, height, 0, (n) => new Uint32Array(n));
  }

  polygon(id: string): Polygon {
    const polygon = this.scene.byId.get(id);
    if (polygon === undefined) throw new Refusal('polygon', 'noSuchPolygon', id);
    return polygon;
  }

  /** The index of a polygon in the scene. */
  placeOf(id: string): number {
    this.places ??= new Map(this.scene.polygons.map((polygon, i) => [polygon.id, i]));
    return this.places.get(id) ?? -1;
  }

  /** Paints pixels of the plane, which must be in the area. */
  paint(x: number, y: number, width: number, height: number, color: string): void {
    this.expectInside(x, y, width, height);
    const { area } = this.scene;
    const [i, j] = [x - area.x, y - area.y];
    this.picture.fill(i, j, width, height, toPixel(color));
    this.painters.fill(i, j, width, height, this.step);
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

  /** Records a window, a part of the first one, as the smallest that contains its pixels' centres. */
  divide(window: Box, root: Box): void {
    const { area } = this.scene;
    if (!this.isCut) halve(this.division, area, window, root);
    else {
      this.expectCut(window);
      cut(this.division, area, window);
    }
  }

  /** Checks that a window that is cut anywhere has whole pixels. */
  protected expectCut([x, y, width, height]: Box): void {
    if (![x, y, width, height].every(Number.isInteger)) throw new Refusal('window', 'outsideArea');
    this.expectInside(x, y, width, height);
  }

  /** The distinguishable windows into which the area is divided: the same list until one is divided. */
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
    this.painters.fill(0, 0, width, height, 0);
    this.isGround = true;
    if (this.hasDepths) this.z = this.depths(z);
  }

  save(): SavedScreen {
    const { picture, division, painters, z, isGround } = this;
    return {
      picture: picture.save(),
      division: division.save(),
      painters: painters.save(),
      z: z?.save() ?? null,
      isGround,
    };
  }

  load({ picture, division, painters, z, isGround }: SavedScreen): void {
    this.isGround = isGround;
    this.picture.load(picture);
    this.division.load(division);
    this.painters.load(painters);
    if (z === null) this.z = null;
    else (this.z ??= this.depths('-inf')).load(z);
  }

  private depths(z: N): Grid<N> {
    const { width, height } = this.scene.area;
    return new Grid<N>(width, height, z, (n) => new Array<N>(n).fill(z));
  }
}

/** A screen that only checks whether something can be painted. */
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
    // Paints nothing.
  }
}

export interface SavedScreen {
  readonly picture: readonly Row<number>[];
  readonly division: readonly Row<number>[];
  readonly painters: readonly Row<number>[];
  readonly z: readonly Row<N>[] | null;
  readonly isGround: boolean;
}
