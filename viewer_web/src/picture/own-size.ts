import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Point, Size } from './frame.js';

/** The number of page pixels per pixel of the element; not all browsers know it. */
const zoomOf = (element: Partial<Element>): number => element.currentCSSZoom ?? 1;

/** The place of a pointer in an element, in the element's own pixels. */
export function pointIn(element: Element, { clientX, clientY }: MouseEvent): Point {
  const { left, top } = element.getBoundingClientRect();
  const zoom = zoomOf(element);
  return [(clientX - left) / zoom, (clientY - top) / zoom];
}

/** The size of an element on the page; when it changes, the element renders again. */
export class OwnSize implements ReactiveController {
  value: Size = { width: 0, height: 0 };
  /** The number of page pixels per own pixel. Reading it forces the browser to lay out the page. */
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
