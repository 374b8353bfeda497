/** A row of cells: a plain or a typed array. */
export interface Row<T> {
  readonly length: number;
  [index: number]: T;
  fill(value: T, first?: number, end?: number): Row<T>;
  slice(): Row<T>;
}

/**
 * Cells in rows that are copied only when written after a snapshot, so that a keyframe of a picture costs no
 * more than what changes. Rows that hold one value throughout are one row.
 */
export class Grid<T> {
  private rows: Row<T>[];
  private readonly owned = new Set<number>();

  constructor(
    readonly width: number,
    readonly height: number,
    value: T,
    private readonly make: (width: number) => Row<T>,
  ) {
    this.rows = new Array<Row<T>>(height).fill(make(width).fill(value));
  }

  row(j: number): Row<T> {
    const row = this.rows[j];
    if (row === undefined) throw new RangeError(`row ${j} of ${this.height}`);
    return row;
  }

  fill(x: number, y: number, width: number, height: number, value: T): void {
    if (width === this.width && height > 0) this.replace(y, height, this.make(width).fill(value));
    else for (let j = y; j < y + height; j++) this.writable(j).fill(value, x, x + width);
  }

  set(x: number, y: number, value: T): void {
    this.writable(y)[x] = value;
  }

  /** The cells as they are now. */
  copy(): Grid<T> {
    const copy = new Grid(this.width, this.height, this.row(0)[0] as T, this.make);
    copy.load(this.save());
    return copy;
  }

  save(): readonly Row<T>[] {
    this.owned.clear();
    return this.rows.slice();
  }

  load(saved: readonly Row<T>[]): void {
    this.owned.clear();
    this.rows = saved.slice();
  }

  private replace(y: number, height: number, row: Row<T>): void {
    for (let j = y; j < y + height; j++) {
      this.rows[j] = row;
      this.owned.delete(j);
    }
  }

  private writable(j: number): Row<T> {
    if (this.owned.has(j)) return this.row(j);
    const copy = this.row(j).slice();
    this.rows[j] = copy;
    this.owned.add(j);
    return copy;
  }
}

/** A colour `#rrggbb` as the four bytes that a canvas takes, and back. */
export function toPixel(color: string): number {
  const rgb = Number.parseInt(color.slice(1), 16);
  return (0xff000000 | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** The same where nothing was painted yet: the byte that tells how opaque a canvas takes it is 0. */
export const toGround = (color: string): number => toPixel(color) & 0xffffff;
export const isPainted = (pixel: number): boolean => pixel >>> 24 !== 0;

export function toColor(pixel: number): string {
  const rgb = ((pixel & 0xff) << 16) | (pixel & 0xff00) | ((pixel >> 16) & 0xff);
  return `#${rgb.toString(16).padStart(6, '0')}`;
}
