/** Milliseconds: browsers limit how often an address may change. */
const pause = 250;
/** Milliseconds: what follows sooner belongs to the same move, as of a slider that is dragged. */
const same = 300;

/** The page's address, and the browser's history with an entry for each jump, so that *Back* undoes it. */
export class Trail {
  private timer = 0;
  private moved = -Infinity;

  constructor(private readonly compose: () => Promise<string>) {}

  /** What is shown has changed. */
  write(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      void this.compose().then((address) => history.replaceState(null, '', address));
    }, pause);
  }

  /** Something else is about to be shown: *Back* shall lead to what is shown now, whose address it is. */
  leave(address: string | null): void {
    const isSame = performance.now() < this.moved + same;
    this.moved = performance.now();
    if (isSame) return;
    if (address !== null) history.replaceState(null, '', address);
    history.pushState(null, '', location.href);
    this.write();
  }

  /** The address says what is not shown: the reader wanted to stay. */
  restore(address: string): void {
    history.pushState(null, '', address);
  }
}

/** Whether a change of the step is more than playing on or stepping. */
export const isJump = (from: number, to: number): boolean => Math.abs(to - from) > 1;
