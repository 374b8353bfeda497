import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { nextThing, thingAt } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';

/** The thing that is pointed at on the page, by mouse, finger or keyboard; see `pointed.ts`. */
export class Pointing implements ReactiveController {
  private thing: string | null = null;

  constructor(private readonly host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostConnected(): void {
    this.point(null);
  }

  get at(): string | null {
    return this.thing;
  }

  /** Moves to the next or previous thing of the step. */
  move(by: 1 | -1, view: View): void {
    this.point(nextThing(this.thing, by, view));
  }

  readonly onOver = (event: Event): void => this.point(thingAt(event));

  /** A lifted finger keeps pointing. */
  readonly onLeave = ({ pointerType }: PointerEvent): void => {
    if (pointerType !== 'touch') this.point(null);
  };

  private point(thing: string | null): void {
    if (thing === this.thing) return;
    this.thing = thing;
    this.host.requestUpdate();
  }
}
