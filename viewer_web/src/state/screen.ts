import type { Polygon, Scene } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Box, N } from '../trace/values.js';
import { Grid, toGround, toPixel } from './grid.js';
import type { Row } from './grid.js';

/**
 * What the handlers of events write to: the picture, how the area is divided into windows and, where the trace carries
 * it, the buffer of depths.
 */
export class Screen {
  /** Pixels; where nothing was painted yet those of the ground. */
  readonly picture: Grid<number>;
  /** How often the first window was halved to get the smallest one that a pixel is in. */
  readonly levels: Grid<number>;
  z: Grid<N> | null = null;

  constructor(
    readonly scene: Scene,
    private readonly hasDepths: boolean,
  ) {
    const { width, height } = scene.area;
    const ground = toGround(scene.background);
    this.picture = new Grid<number>(width, height, ground, (n) => new Uint32Array(n));
    this.levels = new Grid<number>(width, height, 0, (n) => new Uint8Array(n));
  }

  polygon(id: string): Polygon {
    const polygon = this.scene.byId.get(id);
    if (polygon === undefined) throw new Refusal('polygon', 'noSuchPolygon', id);
    return polygon;
  }

  /** Pixels of the plane take a colour; they must lie in the area. */
  paint(x: number, y: number, width: number, height: number, color: string): void {
    const { area } = this.scene;
    const i = x - area.x;
    const j = y - area.y;
    const inside = i >= 0 && j >= 0 && width >= 0 && height >= 0;
    if (!inside || i + width > area.width || j + height > area.height) {
      throw new Refusal('', 'outsideArea');
    }
    this.picture.fill(i, j, width, height, toPixel(color));
  }

  /** The pixels whose centres lie in a window are in one of this level. */
  divide([x, y, width, height]: Box, level: number): void {
    const { area } = this.scene;
    const cell = (at: number, from: number, cells: number): number =>
      Math.min(Math.max(Math.ceil(at - from - 0.5), 0), cells);
    const i = cell(x, area.x, area.width);
    const j = cell(y, area.y, area.height);
    const across = cell(x + width, area.x, area.width) - i;
    this.levels.fill(i, j, across, cell(y + height, area.y, area.height) - j, level);
  }

  clear(color: string, z: N): void {
    const { width, height } = this.scene.area;
    this.picture.fill(0, 0, width, height, toGround(color));
    if (this.hasDepths) this.z = this.depths(z);
  }

  save(): SavedScreen {
    const { picture, levels, z } = this;
    return { picture: picture.save(), levels: levels.save(), z: z?.save() ?? null };
  }

  load({ picture, levels, z }: SavedScreen): void {
    this.picture.load(picture);
    this.levels.load(levels);
    if (z === null) this.z = null;
    else (this.z ??= this.depths('-inf')).load(z);
  }

  private depths(z: N): Grid<N> {
    const { width, height } = this.scene.area;
    return new Grid<N>(width, height, z, (n) => new Array<N>(n).fill(z));
  }
}

export interface SavedScreen {
  readonly picture: readonly Row<number>[];
  readonly levels: readonly Row<number>[];
  readonly z: readonly Row<N>[] | null;
}
