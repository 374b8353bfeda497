/** Rows of cells to paint. Each cell is a colour in the four bytes of a canvas pixel; the last byte is its texture. */
export interface Cells {
  readonly width: number;
  readonly height: number;
  /** The cells are unchanged as long as these values are. */
  readonly of: readonly unknown[];
  /** The cells of a row in some columns: only a few cells of a large picture are visible. */
  row(j: number, columns: readonly number[]): ArrayLike<number>;
}

/** The position of cells on a canvas, in device pixels. */
export interface Place {
  /** The corner of the first cell, which may be off the canvas. */
  readonly x: number;
  readonly y: number;
  /** The side of a cell. */
  readonly scale: number;
  /** Device pixels per CSS pixel. */
  readonly ratio: number;
}

const plain = 0xff;
const black = 0xff1c1310;
const white = 0xffffffff;
const grey = 0xff98877c;
const clear = 0;

/** Textures of cells, made of hatches and dots, at a point in CSS pixels. */
const textures = {
  /** Dark and light stripes. */
  wrong: (x: number, y: number, own: number) => [black, black, white, own][((x + y) >> 1) & 3],
  /** Dots. */
  lacking: (x: number, y: number, own: number) => (x % 5 < 2 && y % 5 < 2 ? black : own),
  /** Thin lines on the background. */
  nothing: (x: number, y: number) => ((x + 6000 - y) % 6 === 0 ? grey : clear),
} as const;
export type Texture = keyof typeof textures;
const names = Object.keys(textures) as Texture[];
const ways = Object.values(textures);

/** A cell of one colour. */
export const opaque = (color: number): number => (color | 0xff000000) >>> 0;

/** A cell with a texture. */
export const textured = (texture: Texture, color: number): number =>
  ((color & 0xffffff) | ((names.indexOf(texture) + 1) << 24)) >>> 0;

function inkOf(cell: number, x: number, y: number): number {
  const way = ways[(cell >>> 24) - 1];
  return way?.(x, y, opaque(cell)) ?? cell;
}

const none = -1;

/** The cell at the middle of each dot. */
function cellsAlong(dots: number, from: number, scale: number, cells: number): readonly number[] {
  return Array.from({ length: dots }, (_, dot) => {
    const cell = Math.floor((dot + 0.5 - from) / scale);
    return cell >= 0 && cell < cells ? cell : none;
  });
}

/** Adjacent rows of dots that show the same row of cells. */
interface Band {
  readonly cell: number;
  readonly first: number;
  readonly end: number;
}

function bandsOf(cells: readonly number[]): readonly Band[] {
  const bands: Band[] = [];
  for (let first = 0, end = 0; first < cells.length; first = end) {
    const cell = cells[first] ?? none;
    do end++;
    while (end < cells.length && cells[end] === cell);
    if (cell !== none) bands.push({ cell, first, end });
  }
  return bands;
}

/** The mapping from the cells of a place to the dots of a canvas. */
class Raster {
  /** The visible columns. */
  readonly columns: readonly number[];
  /** For each dot of a row, the index of its cell in the columns. */
  private readonly across: Int32Array;
  private readonly bands: readonly Band[];
  /** The last painted cells of each band. */
  private readonly painted: ArrayLike<number>[] = [];
  private readonly dots: Uint32Array;

  constructor(
    readonly image: ImageData,
    readonly cells: Pick<Cells, 'width' | 'height'>,
    readonly place: Place,
  ) {
    const { width, height, data } = image;
    const { x, y, scale } = place;
    const across = cellsAlong(width, x, scale, cells.width);
    this.columns = [...new Set(across)].filter((i) => i !== none);
    const places = new Map(this.columns.map((i, at) => [i, at]));
    this.across = Int32Array.from(across, (i) => places.get(i) ?? none);
    this.bands = bandsOf(cellsAlong(height, y, scale, cells.height));
    this.dots = new Uint32Array(data.buffer);
  }

  isOf({ width, height }: HTMLCanvasElement, cells: Cells, place: Place): boolean {
    const { image, cells: own, place: at } = this;
    return (
      image.width === width &&
      image.height === height &&
      own.width === cells.width &&
      own.height === cells.height &&
      at.x === place.x &&
      at.y === place.y &&
      at.scale === place.scale &&
      at.ratio === place.ratio
    );
  }

  /** Paints the rows that have changed, and returns the range of their rows of dots. */
  paint(cells: Cells): readonly [first: number, end: number] {
    let [top, bottom] = [Infinity, 0];
    this.bands.forEach((band, i) => {
      const row = cells.row(band.cell, this.columns);
      if (areEqual(row, this.painted[i])) return;
      this.painted[i] = row;
      this.fill(band, row);
      top = Math.min(top, band.first);
      bottom = band.end;
    });
    return [Math.min(top, bottom), bottom];
  }

  private fill({ first, end }: Band, row: ArrayLike<number>): void {
    const { dots, across } = this;
    const { width } = this.image;
    const { ratio } = this.place;
    const hasTexture = Array.from(row).some((cell) => cell >>> 24 !== plain);
    for (let y = first; y < end; y++) {
      const start = y * width;
      if (y > first && !hasTexture) {
        dots.copyWithin(start, start - width, start);
        continue;
      }
      const down = Math.floor(y / ratio);
      for (let x = 0; x < width; x++) {
        const cell = row[across[x] ?? none] ?? clear;
        dots[start + x] = hasTexture ? inkOf(cell, Math.floor(x / ratio), down) : cell;
      }
    }
  }
}

function areEqual<T>(a: ArrayLike<T>, b: ArrayLike<T> | undefined): boolean {
  if (b?.length !== a.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

/**
 * Paints cells dot by dot on a canvas. Each is a sharp square, at most half a dot from its place. Unchanged cells are not
 * repainted, as most steps of a run paint nothing.
 */
export class CellPainter {
  private raster: Raster | null = null;
  /** The values on which the last painted cells depend. */
  private of: readonly unknown[] = [];

  paint(canvas: HTMLCanvasElement, cells: Cells | null, place: Place): void {
    const { width, height } = canvas;
    const context = canvas.getContext('2d');
    if (context === null || width === 0 || height === 0) return;
    if (cells === null) {
      this.raster = null;
      context.clearRect(0, 0, width, height);
      return;
    }
    const isOld = this.raster?.isOf(canvas, cells, place) === true;
    if (isOld && areEqual(cells.of, this.of)) return;
    this.of = cells.of;
    if (!isOld) this.raster = new Raster(context.createImageData(width, height), cells, place);
    const { raster } = this;
    if (raster === null) return;
    const [first, end] = raster.paint(cells);
    if (!isOld) context.putImageData(raster.image, 0, 0);
    else if (end > first) context.putImageData(raster.image, 0, 0, 0, first, width, end - first);
  }
}
