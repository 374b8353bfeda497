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
