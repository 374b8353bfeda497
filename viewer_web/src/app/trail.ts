/** Milliseconds: browsers limit how often an address may change. */
const pause = 250;
/** Milliseconds: changes that follow each other sooner belong to the same move, such as the drag of a slider. */
const same = 300;

/** The page's address, and the browser's history with an entry for each jump, so that *Back* undoes the jump. */
export class Trail {
  private timer = 0;
  /** Whether the page's address already names something that is not shown yet. */
  private isAhead = false;
  /** The timer of the last move, until the next one no longer belongs to it. */
  private recent = 0;

  /** `kept` is stored with each entry: what the address cannot hold. */
  constructor(
    private readonly compose: () => Promise<string>,
    private readonly kept: () => unknown,
  ) {}

  /** Writes the address soon after a change. */
  write(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      void this.compose().then((address) => {
        if (!this.isAhead) history.replaceState(this.kept(), '', address);
      });
    }, pause);
  }

  /** Called before something else is shown, with the current address, so that *Back* returns to it. */
  leave(address: string | null): void {
    const isSame = this.recent !== 0;
    clearTimeout(this.recent);
    this.recent = window.setTimeout(() => (this.recent = 0), same);
    if (isSame) return;
    if (address !== null) history.replaceState(this.kept(), '', address);
    history.pushState(null, '', location.href);
    this.write();
  }

  /** Keeps an address that the reader has gone to until the page shows what it names. */
  wait(): void {
    this.isAhead = true;
  }

  /** The page shows what the address names. */
  arrive(): void {
    this.isAhead = false;
  }

  /** Restores the address of what is shown, because the reader wanted to stay. */
  restore(address: string): void {
    this.isAhead = false;
    history.pushState(this.kept(), '', address);
  }
}

/** Whether a change of the step is a jump, not a single step. */
export const isJump = (from: number, to: number): boolean => Math.abs(to - from) > 1;
