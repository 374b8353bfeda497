import type { FloatingHorizonEvents } from '../trace/events.js';
import type { Scene } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { N } from '../trace/values.js';
import { Grid } from './grid.js';
import type { Row } from './grid.js';

type Flag = FloatingHorizonEvents['visibility']['flag'];

/** A height or none over each column of the area. */
type Heights = Grid<N | null>;
type Saved<T> = readonly Row<T>[];

/** The part of it in a keyframe. */
export interface SavedColumns {
  readonly horizons: readonly Saved<N | null>[];
  readonly flags: Saved<Flag | null>;
}

/** The values of the floating horizon over the columns of the area. */
export class Columns {
  readonly horizons: { readonly upper: Heights; readonly lower: Heights };
  /** The horizons at the start of the current curve, which the curve is compared with, except in the printed text. */
  readonly before: { readonly upper: Heights; readonly lower: Heights };
  /** The results of Visibility for the current curve. */
  readonly flags: Grid<Flag | null>;

  constructor(readonly scene: Scene) {
    const { width } = scene.area;
    const heights = (): Heights => new Grid<N | null>(width, 1, null, (n) => new Array<N>(n));
    this.horizons = { upper: heights(), lower: heights() };
    this.before = { upper: heights(), lower: heights() };
    this.flags = new Grid<Flag | null>(width, 1, null, (n) => new Array<Flag>(n));
  }

  begin(upper: N | null, lower: N | null): void {
    const { horizons, scene } = this;
    horizons.upper.fill(0, 0, scene.area.width, 1, upper);
    horizons.lower.fill(0, 0, scene.area.width, 1, lower);
  }

  /** Starts another curve, of which nothing was examined. */
  forget(): void {
    this.flags.fill(0, 0, this.scene.area.width, 1, null);
    this.keep();
  }

  /** Makes the current horizons those before the curve. */
  keep(): void {
    const { horizons, before } = this;
    before.upper.load(horizons.upper.save());
    before.lower.load(horizons.lower.save());
  }

  look(x: number, flag: Flag): void {
    this.flags.set(this.indexOf(x), 0, flag);
  }

  raise(x: number, y: N): void {
    this.horizons.upper.set(this.indexOf(x), 0, y);
  }

  lower(x: number, y: N): void {
    this.horizons.lower.set(this.indexOf(x), 0, y);
  }

  save(): SavedColumns {
    return { horizons: this.heights.map((each) => each.save()), flags: this.flags.save() };
  }

  load({ horizons, flags }: SavedColumns): void {
    this.heights.forEach((each, i) => each.load(horizons[i] ?? []));
    this.flags.load(flags);
  }

  private get heights(): readonly Heights[] {
    const { horizons, before } = this;
    return [horizons.upper, horizons.lower, before.upper, before.lower];
  }

  private indexOf(x: number): number {
    const { area } = this.scene;
    if (x < area.x || x >= area.x + area.width) throw new Refusal('', 'outsideArea');
    return x - area.x;
  }
}
