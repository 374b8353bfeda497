import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Point, Size } from './frame.js';

/** How many pixels of the page one of the element's own is; not all browsers know. */
const zoomOf = (element: Partial<Element>): number => element.currentCSSZoom ?? 1;

/** Where in an element a pointer is, in the element's own pixels. */
export function pointIn(element: Element, { clientX, clientY }: MouseEvent): Point {
  const { left, top } = element.getBoundingClientRect();
  const zoom = zoomOf(element);
  return [(clientX - left) / zoom, (clientY - top) / zoom];
}

/** The size that an element has on the page; when it changes, the element is drawn anew. */
export class OwnSize implements ReactiveController {
  value: Size = { width: 0, height: 0 };
  /** How many pixels of the page one of its own is. To ask for it makes the browser lay out the page. */
  zoom = 1;

  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry === undefined) return;
    this.value = { width: entry.contentRect.width, height: entry.contentRect.height };
    this.zoom = zoomOf(this.host);
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
