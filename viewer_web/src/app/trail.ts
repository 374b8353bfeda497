/** Milliseconds: browsers limit how often an address may change. */
const pause = 250;
/** Milliseconds: changes that follow each other sooner belong to the same move, such as the drag of a slider. */
const same = 300;

/** The page's address, and the browser's history with an entry for each jump, so that *Back* undoes the jump. */
export class Trail {
  private timer = 0;
  private moved = -Infinity;

  /** `place` is kept with each entry: what the address cannot hold. */
  constructor(
    private readonly compose: () => Promise<string>,
    private readonly place: () => unknown,
  ) {}

  /** Writes the address soon after a change. */
  write(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      void this.compose().then((address) => history.replaceState(this.place(), '', address));
    }, pause);
  }

  /** Called before something else is shown, with the current address, so that *Back* returns to it. */
  leave(address: string | null): void {
    const isSame = performance.now() < this.moved + same;
    this.moved = performance.now();
    if (isSame) return;
    if (address !== null) history.replaceState(this.place(), '', address);
    history.pushState(null, '', location.href);
    this.write();
  }

  /** Restores the address of what is shown, because the reader wanted to stay. */
  restore(address: string): void {
    history.pushState(null, '', address);
  }
}

/** Whether a change of the step is a jump, not a single step. */
export const isJump = (from: number, to: number): boolean => Math.abs(to - from) > 1;
