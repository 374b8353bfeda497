/** The wheel distance in CSS pixels that doubles the size. A touchpad reports two fingers as a wheel with Ctrl. */
const doubled = { wheel: 300, fingers: 70 };
/** CSS pixels per wheel unit: a pixel, a line or a page. */
const wheelUnits = [1, 16, 400];

/** The effect of gestures on the visible part of a run; places and distances are shares of the strip. */
interface Zoomed {
  readonly isWhole: boolean;
  zoom(by: number, place: number): void;
  move(by: number): void;
}

interface Spread {
  readonly middle: number;
  readonly size: number;
}

/** Zooms and moves a strip by wheel and by two fingers; one finger seeks. */
export class StripGestures {
  private readonly fingers = new Map<number, number>();

  constructor(
    private readonly zoomed: Zoomed,
    private readonly changed: () => void,
  ) {}

  /** Whether there are two fingers, so that neither of them seeks. */
  get isPinch(): boolean {
    return this.fingers.size > 1;
  }

  /** A wheel that would show more than the whole scrolls the page instead. */
  readonly onWheel = (event: WheelEvent): void => {
    const { deltaX, deltaY, deltaMode, ctrlKey, shiftKey } = event;
    const unit = wheelUnits[deltaMode] ?? 1;
    const isAlong = shiftKey || Math.abs(deltaX) > Math.abs(deltaY);
    const way = unit * (isAlong && deltaX !== 0 ? deltaX : deltaY);
    const { zoomed } = this;
    if (way === 0 || (zoomed.isWhole && !ctrlKey && (way > 0 || isAlong))) return;
    event.preventDefault();
    const strip = event.currentTarget as Element;
    if (isAlong) zoomed.move(way / strip.getBoundingClientRect().width);
    else zoomed.zoom(2 ** (-way / (ctrlKey ? doubled.fingers : doubled.wheel)), shareOf(event));
    this.changed();
  };

  readonly onDown = (event: PointerEvent): void => {
    if (event.button === 0) this.fingers.set(event.pointerId, shareOf(event));
  };

  /** The places under two fingers stay under them. */
  readonly onMove = (event: PointerEvent): void => {
    if (!this.fingers.has(event.pointerId)) return;
    if (event.buttons === 0) {
      this.onEnd(event);
      return;
    }
    const before = this.spread();
    this.fingers.set(event.pointerId, shareOf(event));
    const after = this.spread();
    if (before === null || after === null) return;
    this.zoomed.zoom(after.size / before.size, before.middle);
    this.zoomed.move(before.middle - after.middle);
    this.changed();
  };

  readonly onEnd = ({ pointerId }: PointerEvent): void => {
    this.fingers.delete(pointerId);
  };

  /** The centre and distance of two fingers; the distance is at least the width of a finger. */
  private spread(): Spread | null {
    const [one, other] = this.fingers.values();
    if (one === undefined || other === undefined) return null;
    return { middle: (one + other) / 2, size: Math.max(Math.abs(one - other), 0.02) };
  }
}

/** The position of a pointer along a strip, from 0 to 1. */
export function shareOf({ clientX, currentTarget }: MouseEvent): number {
  const { left, width } = (currentTarget as Element).getBoundingClientRect();
  return width === 0 ? 0 : (clientX - left) / width;
}
