import type { PropertyValues, ReactiveControllerHost } from 'lit';
import { historyOf } from './history.js';
import type { History } from './history.js';
import type { Pixel } from '../picture/pixel.js';
import type { Trace } from '../replay/trace.js';
import { ReadOn } from '../elements/read-on.js';
import type { Side } from './side-name.js';

const mostPerFrame = 60;

/** The parts of the player that the history of the chosen pixel uses. */
interface Host extends ReactiveControllerHost, EventTarget {
  readonly trace: Trace | null;
  readonly isFull: boolean;
  pixel: Pixel | null;
  side: Side;
}

/** The history of the player's pixel, collected over several frames. */
export class PixelHistory {
  history: History | null = null;
  private readonly reader: ReadOn;

  constructor(private readonly host: Host) {
    this.reader = new ReadOn(host, mostPerFrame);
  }

  follow(changed: PropertyValues<Host>): void {
    if (changed.has('trace') || changed.has('pixel')) this.open(changed.has('pixel'));
    this.reader.read(this.history);
  }

  /**
   * Opens the panel for a chosen pixel. It stays open, because each run of a scene is a new trace, unless no pixel is
   * chosen any more.
   */
  private open(isChosen: boolean): void {
    const { host } = this;
    this.history = historyOf(host.trace, host.pixel);
    if (this.history !== null && isChosen) host.side = 'pixel';
    if (this.history === null && host.side === 'pixel') host.side = 'state';
  }

  choose(pixel: Pixel | null): void {
    const { host } = this;
    if (!host.isFull) return;
    host.pixel = pixel;
    host.side = pixel === null ? 'state' : 'pixel';
    host.dispatchEvent(new CustomEvent('vidno-pixel', { detail: pixel }));
  }
}
