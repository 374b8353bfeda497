import type { Run, Subject } from './format.js';
import type { ScenePictures } from './scene-format.js';
import { isSurface } from './subject.js';
import type { SurfacePictures } from './surface-format.js';

/** Pixels of one colour beside each other. */
export interface Strip {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly color: string;
}

export type Line = readonly (readonly [x: number, y: number])[];

/** What a run shows: strips of pixels, or the lines of a surface. */
export interface Shot {
  readonly width: number;
  readonly height: number;
  readonly strips: readonly Strip[];
  readonly lines: readonly Line[];
}

/** The picture of a run beside the right one. */
export interface Pair {
  readonly own: Shot;
  readonly right: Shot;
  /** Where the colours of the two differ. */
  readonly wrong: readonly Strip[];
}

/** The colours of all pixels, by index. The lengths add up to the number of pixels. */
function pixelsOf(runs: readonly number[], pixels: number): readonly number[] | null {
  const lengths = runs.filter((_, i) => i % 2 === 0);
  if (lengths.reduce((sum, length) => sum + length, 0) !== pixels) return null;
  return lengths.flatMap((length, i) => new Array<number>(length).fill(runs[2 * i + 1] ?? 0));
}

/** Strips of equal pixels, row by row; a pixel without a colour is in none. */
function stripsOf(
  pixels: readonly number[],
  width: number,
  colorOf: (pixel: number, at: number) => string | undefined,
): readonly Strip[] {
  const strips: (Strip & { width: number })[] = [];
  for (const [at, pixel] of pixels.entries()) {
    const color = colorOf(pixel, at);
    if (color === undefined) continue;
    const [x, y] = [at % width, Math.floor(at / width)];
    const last = strips.at(-1);
    const goesOn = last?.y === y && last.x + last.width === x && last.color === color;
    if (goesOn) last.width++;
    else strips.push({ x, y, width: 1, color });
  }
  return strips;
}

function pairOfPixels(
  { width, colors, shown }: ScenePictures,
  pixels: number,
  picture: number,
): Pair | null {
  const [right, own] = [shown[0], shown[picture]].map((runs) => runs && pixelsOf(runs, pixels));
  if (!own || !right) return null;
  const shot = (of: readonly number[]): Shot => ({
    width,
    height: pixels / width,
    strips: stripsOf(of, width, (pixel) => colors[pixel]),
    lines: [],
  });
  const wrong = stripsOf(own, width, (pixel, at) => (pixel === right[at] ? undefined : 'wrong'));
  return { own: shot(own), right: shot(right), wrong };
}

const lineOf = (numbers: readonly number[]): Line =>
  numbers.flatMap((x, i) => {
    const y = numbers[i + 1];
    return i % 2 > 0 || y === undefined ? [] : [[x, y] as const];
  });

function pairOfLines({ width, height, shown }: SurfacePictures, picture: number): Pair | null {
  const [right, own] = [shown[0], shown[picture]];
  if (own === undefined || right === undefined) return null;
  const shot = (of: readonly (readonly number[])[]): Shot => ({
    width,
    height,
    strips: [],
    lines: of.map(lineOf),
  });
  return { own: shot(own), right: shot(right), wrong: [] };
}

/** Larger areas are not charted. */
const mostPixels = 512 * 512;

/** Null if the chart does not contain the run's picture. */
export function pairOf(subject: Subject, { picture }: Run): Pair | null {
  if (picture === undefined || subject.pictures === undefined) return null;
  if (isSurface(subject)) return pairOfLines(subject.pictures, picture);
  const { pixels, pictures } = subject;
  return pixels > mostPixels ? null : pairOfPixels(pictures, pixels, picture);
}
