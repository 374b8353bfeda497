import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Size } from './frame.js';

/** The size of an element in device pixels. When it or the theme changes, the host renders again. */
export class OwnDots implements ReactiveController {
  value: Size = { width: 0, height: 0 };

  private readonly dark = matchMedia('(prefers-color-scheme: dark)');
  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry === undefined) return;
    this.value = dotsOf(entry);
    this.host.requestUpdate();
  });

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly element: () => Element,
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    this.dark.addEventListener('change', this.onTheme);
    void this.host.updateComplete.then(() => this.observe());
  }

  hostDisconnected(): void {
    this.dark.removeEventListener('change', this.onTheme);
    this.observer.disconnect();
  }

  private readonly onTheme = (): void => this.host.requestUpdate();

  private observe(): void {
    try {
      this.observer.observe(this.element(), { box: 'device-pixel-content-box' });
    } catch {
      this.observer.observe(this.element()); // the browser does not support device pixels
    }
  }
}

/** The size that the browser reports. When it emulates another device, the report is wrong and the size is computed. */
function dotsOf({ devicePixelContentBoxSize, contentRect }: ResizeObserverEntry): Size {
  const ratio = window.devicePixelRatio;
  const width = contentRect.width * ratio;
  const height = contentRect.height * ratio;
  const [box] = devicePixelContentBoxSize as readonly ResizeObserverSize[] | [];
  if (box !== undefined && Math.abs(box.inlineSize - width) < 1) {
    return { width: box.inlineSize, height: box.blockSize };
  }
  return { width: Math.round(width), height: Math.round(height) };
}
