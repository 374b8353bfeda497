/** Milliseconds: browsers limit how often an address may change. */
const pause = 250;
/** What a reader does to begin a move. A drag of a slider is one move, and so is a key that is held down. */
const actions = ['pointerdown', 'keydown', 'click', 'change', 'drop'] as const;

/** The page's address, and the browser's history with an entry for each jump, so that *Back* undoes the jump. */
export class Trail {
  private timer = 0;
  /** Whether the page's address already names something that is not shown yet. */
  private isAhead = false;
  /** Whether the reader has done nothing since the last move: what changes then belongs to it, however late it comes. */
  private isSame = false;

  /** `kept` is stored with each entry: what the address cannot hold. */
  constructor(
    private readonly compose: () => Promise<string>,
    private readonly kept: () => unknown,
  ) {
    const act = (event: Event): void => {
      this.isSame &&= event instanceof KeyboardEvent && event.repeat;
    };
    for (const action of actions) window.addEventListener(action, act, { capture: true });
  }

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
    if (this.isSame) return;
    this.isSame = true;
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
