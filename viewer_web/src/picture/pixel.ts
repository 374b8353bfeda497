import type { Area } from '../trace/header.js';

/** A pixel of the plane: the square from (x, y) to (x + 1, y + 1). */
export type Pixel = readonly [x: number, y: number];

export function isOther(a: Pixel | null, b: Pixel | null | undefined): boolean {
  return a?.[0] !== b?.[0] || a?.[1] !== b?.[1];
}

/** Whether a pixel of the plane is one of the picture. */
export function isIn([x, y]: Pixel, area: Area): boolean {
  return x >= area.x && y >= area.y && x < area.x + area.width && y < area.y + area.height;
}

/** The pixel of the picture that is nearest to a pixel of the plane. */
export function nearestIn([x, y]: Pixel, area: Area): Pixel {
  const within = (value: number, from: number, size: number): number =>
    Math.min(Math.max(value, from), from + size - 1);
  return [within(x, area.x, area.width), within(y, area.y, area.height)];
}

/** The directions of the arrow keys. */
export const moves: Readonly<Record<string, Pixel>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The pixel that a key moves to, if it is a move; never outside the picture. */
export function moved([x, y]: Pixel, key: string, far: boolean, area: Area): Pixel | null {
  const move = moves[key];
  if (move === undefined) return null;
  const by = far ? 10 : 1;
  return nearestIn([x + move[0] * by, y + move[1] * by], area);
}
