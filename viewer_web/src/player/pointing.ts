import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { nextThing, thingAt } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';

/** What is pointed at on the page, by mouse, finger or keyboard; see `pointed.ts`. */
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

  /** To the next thing of the step, or the one before. */
  move(by: 1 | -1, view: View): void {
    this.point(nextThing(this.thing, by, view));
  }

  readonly onOver = (event: Event): void => this.point(thingAt(event));

  /** A finger that was lifted points on. */
  readonly onLeave = ({ pointerType }: PointerEvent): void => {
    if (pointerType !== 'touch') this.point(null);
  };

  private point(thing: string | null): void {
    if (thing === this.thing) return;
    this.thing = thing;
    this.host.requestUpdate();
  }
}
