import type { Frame, Point } from './frame.js';
import { pointIn } from './own-size.js';

/** The greatest distance in CSS pixels that a press may move and still be a click. */
const still = 3;
/** The wheel distance in CSS pixels that doubles the size. A touchpad reports two fingers as a wheel with Ctrl. */
const doubled = { wheel: 300, fingers: 70 };
/** CSS pixels per wheel unit: a pixel, a line or a page. */
const wheelUnits = [1, 16, 400];

/**
 * Zooms and moves a frame by wheel, by dragging, and by two fingers. A picture that can be turned is turned by dragging
 * without Shift.
 */
export class Gestures {
  private readonly pointers = new Map<number, Point>();
  private pressed: Point = [0, 0];
  private drags = false;

  constructor(
    private readonly frame: () => Frame,
    private readonly show: (frame: Frame) => void,
    private readonly turn: ((dx: number, dy: number) => void) | null = null,
  ) {}

  /** Whether the last press has moved, and so was not a click. */
  get dragged(): boolean {
    return this.drags;
  }

  /** A wheel that would shrink the whole scrolls the page instead. */
  readonly onWheel = (event: WheelEvent): void => {
    const way = event.deltaY * (wheelUnits[event.deltaMode] ?? 1);
    const { zoom, isSmallest } = this.frame();
    const isWhole = zoom === null || isSmallest;
    if (way === 0 || (way > 0 && isWhole && !event.ctrlKey)) return;
    event.preventDefault();
    const by = 2 ** (-way / (event.ctrlKey ? doubled.fingers : doubled.wheel));
    this.show(this.frame().zoomed(by, pointOf(event)));
  };

  readonly onDown = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const point = pointOf(event);
    if (this.pointers.size === 0) {
      this.drags = false;
      this.pressed = point;
    }
    this.pointers.set(event.pointerId, point);
  };

  readonly onMove = (event: PointerEvent): void => {
    const from = this.pointers.get(event.pointerId);
    if (event.buttons === 0) this.onEnd(event);
    if (from === undefined || event.buttons === 0) return;
    const to = pointOf(event);
    if (!this.drags && this.pointers.size === 1 && distance(this.pressed, to) <= still) return;
    this.drags = true;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    const before = this.spread();
    this.pointers.set(event.pointerId, to);
    const after = this.spread();
    const [dx, dy] = [after.middle[0] - before.middle[0], after.middle[1] - before.middle[1]];
    if (this.turn !== null && this.pointers.size === 1 && !event.shiftKey) {
      this.turn(dx, dy);
      return;
    }
    this.show(
      this.frame()
        .zoomed(after.size / before.size, before.middle)
        .moved(dx, dy),
    );
  };

  readonly onEnd = ({ pointerId }: PointerEvent): void => {
    this.pointers.delete(pointerId);
  };

  /** Two fingers on the picture do not scroll the page. */
  readonly onTouch = (event: TouchEvent): void => {
    if (event.touches.length > 1) event.preventDefault();
  };

  /** The centre of the pointers and their distance; a single pointer has a constant distance. */
  private spread(): { readonly middle: Point; readonly size: number } {
    const [a = [0, 0], b = a] = this.pointers.values();
    const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    return { middle, size: a === b ? 1 : Math.max(distance(a, b), 1) };
  }
}

/** The place of a pointer in the listening element. */
const pointOf = (event: MouseEvent): Point => pointIn(event.currentTarget as Element, event);

const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
