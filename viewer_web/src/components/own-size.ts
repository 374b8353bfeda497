import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Size } from '../picture/frame.js';

/** The size that an element has on the page; when it changes, the element is drawn anew. */
export class OwnSize implements ReactiveController {
  value: Size = { width: 0, height: 0 };

  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry === undefined) return;
    this.value = { width: entry.contentRect.width, height: entry.contentRect.height };
    this.host.requestUpdate();
  });

  /** How many pixels of the page one of its own is; not all browsers know. */
  get zoom(): number {
    return (this.host as Partial<Element>).currentCSSZoom ?? 1;
  }

  constructor(private readonly host: ReactiveControllerHost & Element) {
    host.addController(this);
  }

  hostConnected(): void {
    this.observer.observe(this.host);
  }

  hostDisconnected(): void {
    this.observer.disconnect();
  }
}
