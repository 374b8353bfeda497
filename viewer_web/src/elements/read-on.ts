import type { ReactiveController, ReactiveControllerHost } from 'lit';

/**
 * Milliseconds of rest before anything is computed for a run beyond what a frame needs. During a drag, no run rests that
 * long.
 */
export const rest = 150;

/**
 * Data collected in one pass over a run. Each call continues for about the given time and returns whether the data are
 * complete.
 */
interface Reading {
  read(milliseconds: number): boolean;
}

/** Reads for a part of each frame. After that the element renders again, and asks for more. */
export class ReadOn implements ReactiveController {
  private frame = 0;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly mostPerFrame: number,
  ) {
    host.addController(this);
  }

  read(reading: Reading | null): void {
    cancelAnimationFrame(this.frame);
    if (reading === null || reading.read(this.mostPerFrame)) return;
    this.frame = requestAnimationFrame(() => this.host.requestUpdate());
  }

  hostDisconnected(): void {
    cancelAnimationFrame(this.frame);
  }
}
