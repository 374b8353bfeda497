/** While it runs, tells at each frame how many steps are due. */
export class Clock {
  private frame = 0;
  private last = 0;
  private due = 0;

  constructor(
    private readonly speed: () => number,
    private readonly advance: (steps: number) => void,
  ) {}

  start(): void {
    this.last = performance.now();
    this.due = 0;
    this.frame = requestAnimationFrame(this.tick);
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
  }

  private readonly tick = (now: number): void => {
    this.due += (Math.max(0, now - this.last) / 1000) * this.speed();
    this.last = now;
    const steps = Math.floor(this.due);
    this.due -= steps;
    this.frame = requestAnimationFrame(this.tick);
    this.advance(steps);
  };
}
