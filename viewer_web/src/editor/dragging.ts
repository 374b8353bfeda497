import type { Frame } from '../picture/frame.js';
import { pointIn } from '../picture/own-size.js';
import type { Sketch } from '../run/sketch.js';
import { act } from './form.js';
import { snapped } from './corner-keys.js';
import type { Place } from './corner-keys.js';

/** The layer over a picture. The position of the plane in it may change during a drag. */
type Host = Element & { readonly frame: Frame };

/** Drags editable parts of the scene in the plane of a picture. */
export class Dragging {
  private drags = 0;

  constructor(private readonly host: Host) {}

  /** The allowed place of a corner that is nearest to the pointer, at an offset from it. */
  placeOf(event: PointerEvent, offset: Place = [0, 0]): Place {
    const [x, y] = this.planeAt(event);
    return snapped([x + offset[0], y + offset[1]], event);
  }

  /** Follows the pointer until it is released, with a part that started at a place. */
  start(event: PointerEvent, start: Place, move: (to: Place, old: Sketch) => Sketch): void {
    if (event.button !== 0) return;
    event.preventDefault();
    const target = event.currentTarget as SVGElement;
    target.setPointerCapture(event.pointerId);
    target.focus();
    const [x, y] = this.planeAt(event);
    const offset: Place = [start[0] - x, start[1] - y];
    const name = `drag ${++this.drags}`;
    let last = start;
    const follow = (moved: PointerEvent): void => {
      const to = this.placeOf(moved, offset);
      if (to[0] === last[0] && to[1] === last[1]) return;
      last = to;
      act(this.host, { do: 'edit', edit: (old) => move(to, old), name });
    };
    const end = (): void => {
      target.removeEventListener('pointermove', follow);
      act(this.host, { do: 'settle' });
    };
    target.addEventListener('pointermove', follow);
    target.addEventListener('lostpointercapture', end, { once: true });
  }

  private planeAt(event: PointerEvent): Place {
    return this.host.frame.at(...pointIn(this.host, event));
  }
}
