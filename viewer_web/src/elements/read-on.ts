import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** What is gathered in one pass over a run, for about so long at a time; says whether it is complete. */
export interface Reading {
  read(milliseconds: number): boolean;
}

/** Reads for a part of each frame; after it the element is drawn anew, and shall ask for more. */
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
