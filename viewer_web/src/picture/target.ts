import type { Rectangle } from './frame.js';
import type { Mark, Spot } from './mark.js';

/** A place in the picture that the reader can choose in answer to a question. */
export interface Target {
  readonly mark: Mark;
  /** What is chosen by it. */
  readonly label: string;
  /** How choosing it works: one of several, any of several, or the next entry of a row. */
  readonly role: 'radio' | 'checkbox' | 'button';
  readonly isChosen: boolean;
  readonly press: () => void;
}

/** The points of a target that must be in sight, so that it can be reached. Some of a window or a pixel always is. */
const spotsOf = ({ mark }: Target): readonly Spot[] => {
  if (mark.kind === 'path') return mark.points;
  return mark.kind === 'point' ? [mark.at] : [];
};

/** The room around targets outside the rectangle, as a share of its size: buttons lie over the edge of the picture. */
const room = 0.2;

/** A rectangle, extended to contain all targets; the same one if it does already. */
export function extended(rectangle: Rectangle, targets: readonly Target[]): Rectangle {
  const [x, y, width, height] = rectangle;
  const spots = targets.flatMap(spotsOf);
  const across = spots.map(([right]) => right);
  const down = spots.map(([, below]) => below);
  const [left, top] = [Math.min(x, ...across), Math.min(y, ...down)];
  const [right, bottom] = [Math.max(x + width, ...across), Math.max(y + height, ...down)];
  if (left === x && top === y && right === x + width && bottom === y + height) return rectangle;
  const around = room * Math.max(width, height);
  return [left - around, top - around, right - left + 2 * around, bottom - top + 2 * around];
}
