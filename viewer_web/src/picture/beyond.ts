import type { Numbers } from '../language/texts.js';
import type { Frame, Point } from './frame.js';
import type { Mark, Role } from './mark.js';
import { pathData } from './shapes.js';
import type { Shape } from './shapes.js';
import type { Label } from './still.js';

/** The roles of points that have arrows. */
const announced: readonly Role[] = ['yes', 'no', 'point'];
/** CSS pixels: the length, half width and distance from the edge of an arrow, and half the width of a letter. */
const arrow = { length: 14, half: 7, off: 3 };
const letter = 4;

/** An arrow and a label at the edge for each point of a step that is out of sight. */
export interface Beyond {
  readonly shapes: readonly Shape[];
  readonly labels: readonly Label[];
}

export function beyond(marks: readonly Mark[], frame: Frame, { point }: Numbers): Beyond {
  const found = new Map<string, { readonly role: Role; readonly at: Point }>();
  for (const mark of marks) {
    if (mark.kind !== 'point' || !announced.includes(mark.role) || isSeen(mark.at, frame)) continue;
    found.set(point(mark.at), mark);
  }
  const all = [...found];
  return {
    shapes: all.map(([, { role, at }]) => ({ look: `dot ${role}`, d: arrowTo(at, frame) })),
    labels: all.map(([text, { at }]) => ({ text, at: nearest(at, frame, besides(text)) })),
  };
}

/** The distance of a label's centre from the edge, so that no letter is cut and the arrow stays visible. */
const besides = (text: string): Point => [
  Math.max(text.length * letter + 6, 2 * arrow.length),
  2 * arrow.length,
];

function isSeen([x, y]: Point, { shown: [left, top, width, height] }: Frame): boolean {
  return x >= left && x <= left + width && y >= top && y <= top + height;
}

/** The visible place nearest to a point, at a distance from the edge in CSS pixels. */
function nearest([x, y]: Point, { shown, scale }: Frame, [across, down]: Point): Point {
  const [left, top, width, height] = shown;
  const within = (at: number, from: number, length: number, inset: number): number =>
    Math.min(Math.max(at, from + inset), from + length - inset);
  return [within(x, left, width, across / scale), within(y, top, height, down / scale)];
}

function arrowTo(at: Point, frame: Frame): string {
  const tip = nearest(at, frame, [arrow.off, arrow.off]);
  const [dx, dy] = [at[0] - tip[0], at[1] - tip[1]];
  const unit = Math.hypot(dx, dy) * frame.scale;
  const [ux, uy] = [dx / unit, dy / unit];
  const back: Point = [tip[0] - ux * arrow.length, tip[1] - uy * arrow.length];
  const [across, down] = [-uy * arrow.half, ux * arrow.half];
  return pathData(
    [tip, [back[0] + across, back[1] + down], [back[0] - across, back[1] - down]],
    true,
  );
}
