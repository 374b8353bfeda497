/** A row of cells: a plain or a typed array. */
export interface Row<T> {
  readonly length: number;
  [index: number]: T;
  fill(value: T, first?: number, end?: number): Row<T>;
  slice(): Row<T>;
}

/** The most cells in a piece. A picture up to this width has one piece per row. */
const most = 256;

/**
 * Cells in rows, and rows in pieces. A piece is copied only when it is written after a snapshot, so that a keyframe of a
 * picture costs no more than the changes. Pieces with a single value may be shared, so that a large area painted in a few
 * rectangles takes little memory.
 */
export class Grid<T> {
  private readonly perRow: number;
  private pieces: Row<T>[];
  /** For each piece, the turn in which it was copied. One copied in this turn is in no snapshot. */
  private readonly copied: Uint32Array;
  private turn = 1;
  /** A number that changes whenever cells may have changed. */
  version = 0;
  /** The last uniform piece, reused for the same value. */
  private plain: { readonly value: T; readonly piece: Row<T> } | null = null;

  constructor(
    readonly width: number,
    readonly height: number,
    value: T,
    private readonly make: (width: number) => Row<T>,
  ) {
    this.perRow = Math.max(1, Math.ceil(width / most));
    this.pieces = new Array<Row<T>>(this.perRow * height);
    this.copied = new Uint32Array(this.pieces.length);
    this.fill(0, 0, width, height, value);
  }

  at(x: number, y: number): T {
    const cell = this.piece(y * this.perRow + Math.floor(x / most))[x % most];
    if (cell === undefined) throw new RangeError(`column ${x} of ${this.width}`);
    return cell;
  }

  /** The cells of a row; a wide row is assembled at each call. */
  row(j: number): Row<T> {
    if (this.perRow === 1) return this.piece(j);
    const row = this.make(this.width);
    for (let k = 0; k < this.perRow; k++) {
      const piece = this.piece(j * this.perRow + k);
      for (let i = 0; i < piece.length; i++) row[k * most + i] = piece[i] as T;
    }
    return row;
  }

  /** Whether two rows are certainly equal because they share their pieces. */
  areSame(j: number, other: number): boolean {
    for (let k = 0; k < this.perRow; k++) {
      if (this.piece(j * this.perRow + k) !== this.piece(other * this.perRow + k)) return false;
    }
    return true;
  }

  fill(x: number, y: number, width: number, height: number, value: T): void {
    this.version++;
    const end = x + width;
    for (let left = x; left < end;) {
      const k = Math.floor(left / most);
      const first = k * most;
      const last = Math.min(first + most, this.width);
      const right = Math.min(last, end);
      const isWhole = left === first && right === last;
      if (isWhole) this.replace(k, y, height, this.filled(last - first, value));
      else {
        for (let j = y; j < y + height; j++) {
          this.writable(j * this.perRow + k).fill(value, left - first, right - first);
        }
      }
      left = right;
    }
  }

  set(x: number, y: number, value: T): void {
    this.version++;
    this.writable(y * this.perRow + Math.floor(x / most))[x % most] = value;
  }

  /** The cells as they are now. */
  copy(): Grid<T> {
    const copy = new Grid(this.width, this.height, this.at(0, 0), this.make);
    copy.load(this.save());
    return copy;
  }

  save(): readonly Row<T>[] {
    this.turn++;
    return this.pieces.slice();
  }

  load(saved: readonly Row<T>[]): void {
    this.version++;
    this.turn++;
    this.pieces = saved.slice();
  }

  private filled(length: number, value: T): Row<T> {
    const { plain } = this;
    if (plain?.value === value && plain.piece.length === length) return plain.piece;
    const piece = this.make(length).fill(value);
    this.plain = { value, piece };
    return piece;
  }

  private replace(k: number, y: number, height: number, piece: Row<T>): void {
    for (let j = y; j < y + height; j++) {
      const place = j * this.perRow + k;
      this.pieces[place] = piece;
      this.copied[place] = 0;
    }
  }

  private piece(place: number): Row<T> {
    const piece = this.pieces[place];
    if (piece === undefined) throw new RangeError(`piece ${place} of ${this.pieces.length}`);
    return piece;
  }

  private writable(place: number): Row<T> {
    if (this.copied[place] === this.turn) return this.piece(place);
    const copy = this.piece(place).slice();
    this.pieces[place] = copy;
    this.copied[place] = this.turn;
    return copy;
  }
}

/** A colour `#rrggbb` as the four bytes of a canvas pixel. */
export function toPixel(color: string): number {
  const rgb = Number.parseInt(color.slice(1), 16);
  return (0xff000000 | ((rgb & 0xff) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
}

/** The same for an unpainted cell: the alpha byte is 0. */
export const toGround = (color: string): number => toPixel(color) & 0xffffff;
export const isPainted = (pixel: number): boolean => pixel >>> 24 !== 0;

export function toColor(pixel: number): string {
  const rgb = ((pixel & 0xff) << 16) | (pixel & 0xff00) | ((pixel >> 16) & 0xff);
  return `#${rgb.toString(16).padStart(6, '0')}`;
}
