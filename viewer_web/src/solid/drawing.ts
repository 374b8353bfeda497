import type { Role } from '../picture/mark.js';
import type { Polygon } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import { around } from './plane.js';
import type { Space, Spot } from './space.js';

/** A line through places, with the look of these classes in the picture's style sheet. */
export interface Line {
  readonly look: string;
  readonly points: readonly Spot[];
  readonly closed: boolean;
  /** Replaces the look's own colour. */
  readonly color?: string;
}

/** A transparent plane figure, of a colour of its own or of glass. */
export interface Face {
  readonly points: readonly Spot[];
  readonly color?: string;
}

/** A text, and the side of its place on which it is: left or right, above or below. */
export interface Label {
  readonly text: string;
  readonly at: Spot;
  readonly side: readonly [across: -1 | 0 | 1, down: -1 | 0 | 1];
  readonly strong?: boolean;
  /** The thing to point at with it; see `pointed.ts`. */
  readonly thing?: string;
}

export interface Dot {
  readonly role: Role;
  readonly at: Spot;
}

/** The content of the box besides the polygons. */
export interface Drawing {
  readonly faces: readonly Face[];
  readonly lines: readonly Line[];
  readonly dots: readonly Dot[];
  readonly labels: readonly Label[];
}

export const noDrawing: Drawing = { faces: [], lines: [], dots: [], labels: [] };

/** Several drawings in one; later ones are on top. */
export function together(...all: readonly Partial<Drawing>[]): Drawing {
  return {
    faces: all.flatMap(({ faces = [] }) => faces),
    lines: all.flatMap(({ lines = [] }) => lines),
    dots: all.flatMap(({ dots = [] }) => dots),
    labels: all.flatMap(({ labels = [] }) => labels),
  };
}

/** A line with a casing, so that it is visible on any colour. */
export function cased(role: Role, points: readonly Spot[], closed = true, color?: string): Line[] {
  const line: Line = { look: role, points, closed };
  return [{ ...line, look: `casing ${role}` }, color === undefined ? line : { ...line, color }];
}

/** The current polygon. */
export const activeDrawing = (polygon: Polygon | undefined): Partial<Drawing> =>
  polygon ? { lines: cased('active', polygon.vertices, true, polygon.color) } : {};

/** A rectangle of the plane at one depth. */
export const level = (box: Box, z: number): readonly Spot[] =>
  around(box).map(([x, y]): Spot => [x, y, z]);

/** A rectangle of the plane as a column along z, from the far end of the box to the near one. */
export function column(box: Box, { far, near }: Space, role: Role): Partial<Drawing> {
  const corners = around(box);
  const sides = corners.map(([x, y], i): readonly Spot[] => {
    const [nextX, nextY] = corners[(i + 1) % corners.length] ?? [x, y];
    return [
      [x, y, far],
      [x, y, near],
      [nextX, nextY, near],
      [nextX, nextY, far],
    ];
  });
  return {
    faces: sides.map((points) => ({ points })),
    lines: [
      ...[far, near].flatMap((z) => cased(role, level(box, z))),
      ...corners.flatMap(([x, y]) => along(x, y, { far, near }, role)),
    ],
  };
}

/** A line parallel to z through the box. */
export const along = (
  x: number,
  y: number,
  { far, near }: Pick<Space, 'far' | 'near'>,
  role: Role,
): readonly Line[] =>
  cased(
    role,
    [
      [x, y, far],
      [x, y, near],
    ],
    false,
  );

/** The drawing in coordinates of the box, without parts that have no place there. */
export function placed({ faces, lines, dots, labels }: Drawing, space: Space): Drawing {
  const path = <T extends { readonly points: readonly Spot[] }>(each: T): readonly T[] => {
    const points = each.points.map((at) => space.place(at));
    return points.length > 0 && points.every(isSomewhere) ? [{ ...each, points }] : [];
  };
  const spot = <T extends { readonly at: Spot }>(each: T): readonly T[] => {
    const at = space.place(each.at);
    return isSomewhere(at) ? [{ ...each, at }] : [];
  };
  return {
    faces: faces.flatMap(path),
    lines: lines.flatMap(path),
    dots: dots.flatMap(spot),
    labels: labels.flatMap(spot),
  };
}

const isSomewhere = (at: Spot): boolean => at.every(Number.isFinite);
