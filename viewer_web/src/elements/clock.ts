import type { ReactiveController, ReactiveControllerHost } from 'lit';

const speeds: readonly number[] = [1, 2, 5, 10, 30, 100, 300];

/** The available speeds in steps per second, including the current one. */
export function speedsWith(speed: number): readonly number[] {
  return speeds.includes(speed) ? speeds : [...speeds, speed].sort((a, b) => a - b);
}

/** The longest time in seconds to play a run until the reader chooses a speed. */
const firstLook = 30;

/** The speed at which a number of steps takes no longer than that. */
export const speedFor = (steps: number): number =>
  speeds.find((speed) => speed >= steps / firstLook) ?? Math.max(...speeds);

/** While it runs, reports at each frame how many steps are due. */
export class Clock implements ReactiveController {
  private running = false;
  private stepsPerSecond = 5;
  private frame = 0;
  private last = 0;
  private due = 0;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly advance: (steps: number) => void,
  ) {
    host.addController(this);
  }

  get playing(): boolean {
    return this.running;
  }

  get speed(): number {
    return this.stepsPerSecond;
  }

  set speed(speed: number) {
    this.stepsPerSecond = speed;
    this.host.requestUpdate();
  }

  /** Chooses the next higher or lower speed. */
  changeSpeed(by: -1 | 1): void {
    const now = speeds.findIndex((speed) => speed >= this.speed);
    this.speed = speeds[now + by] ?? this.speed;
  }

  start(): void {
    this.running = true;
    this.last = performance.now();
    this.due = 0;
    this.frame = requestAnimationFrame(this.tick);
    this.host.requestUpdate();
  }

  stop(): void {
    if (!this.running) return;
    this.running = false;
    cancelAnimationFrame(this.frame);
    this.host.requestUpdate();
  }

  hostDisconnected(): void {
    this.stop();
  }

  private readonly tick = (now: number): void => {
    this.due += (Math.max(0, now - this.last) / 1000) * this.speed;
    this.last = now;
    const steps = Math.floor(this.due);
    this.due -= steps;
    this.frame = requestAnimationFrame(this.tick);
    this.advance(steps);
  };
}
