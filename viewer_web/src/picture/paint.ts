/** What is painted: rows of cells, each a colour in the four bytes that a canvas takes, the last of them its texture. */
export interface Cells {
  readonly width: number;
  readonly height: number;
  /** Cells of a row, those of some columns: of a large picture few are seen. */
  row(j: number, columns: readonly number[]): ArrayLike<number>;
}

/** Where cells lie on a canvas, in dots of the device. */
export interface Place {
  /** The corner of the first cell, which may be off the canvas. */
  readonly x: number;
  readonly y: number;
  /** The side of a cell. */
  readonly scale: number;
  /** Dots of the device per CSS pixel. */
  readonly ratio: number;
}

const plain = 0xff;
const black = 0xff1c1310;
const white = 0xffffffff;
const grey = 0xff98877c;
const clear = 0;

/** Where a cell has another colour than its own, told by hatches and dots; the point is in CSS pixels. */
const textures = {
  /** Dark and light stripes. */
  wrong: (x: number, y: number, own: number) => [black, black, white, own][((x + y) >> 1) & 3],
  /** Dots. */
  lacking: (x: number, y: number, own: number) => (x % 5 < 2 && y % 5 < 2 ? black : own),
  /** Thin lines on the ground. */
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

/** The cell that the middle of each dot lies in. */
function cellsAlong(dots: number, from: number, scale: number, cells: number): readonly number[] {
  return Array.from({ length: dots }, (_, dot) => {
    const cell = Math.floor((dot + 0.5 - from) / scale);
    return cell >= 0 && cell < cells ? cell : none;
  });
}

/** Paints cells dot by dot: each is a sharp square, at most half a dot from its place. */
export function paint(canvas: HTMLCanvasElement, cells: Cells | null, place: Place): void {
  const { width, height } = canvas;
  const context = canvas.getContext('2d');
  if (context === null || width === 0 || height === 0) return;
  const image = context.createImageData(width, height);
  if (cells !== null) fill(new Uint32Array(image.data.buffer), image, cells, place);
  context.putImageData(image, 0, 0);
}

function fill(
  dots: Uint32Array,
  { width, height }: ImageData,
  cells: Cells,
  { x: left, y: top, scale, ratio }: Place,
): void {
  const across = cellsAlong(width, left, scale, cells.width);
  const columns = [...new Set(across)].filter((i) => i !== none);
  const places = new Map(columns.map((i, place) => [i, place]));
  /** For each dot its cell's place among the columns. */
  const dotted = Int32Array.from(across, (i) => places.get(i) ?? none);
  let last = none;
  let row: ArrayLike<number> = [];
  let hasTexture = false;
  cellsAlong(height, top, scale, cells.height).forEach((j, y) => {
    const start = y * width;
    const isNew = j !== last;
    last = j;
    if (j === none) return;
    if (isNew) {
      row = cells.row(j, columns);
      hasTexture = Array.from(row).some((cell) => cell >>> 24 !== plain);
    } else if (!hasTexture) {
      dots.copyWithin(start, start - width, start);
      return;
    }
    const down = Math.floor(y / ratio);
    dotted.forEach((place, x) => {
      const cell = row[place] ?? clear;
      dots[start + x] = hasTexture ? inkOf(cell, Math.floor(x / ratio), down) : cell;
    });
  });
}
