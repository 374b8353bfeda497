/** The properties of a list that the follower reads. */
type List = Pick<HTMLElement, 'scrollTop' | 'clientHeight'>;
type Mark = Pick<HTMLElement, 'offsetTop' | 'offsetHeight'>;

/** Scrolls the mark of a list to a third of the list's height, if the mark is out of sight. */
export function bringInSight(list: List, mark: Mark, above = 0): void {
  const { offsetTop: top, offsetHeight: height } = mark;
  const hidden =
    top - above < list.scrollTop || top + 2 * height > list.scrollTop + list.clientHeight;
  if (hidden) list.scrollTop = top - list.clientHeight / 3;
}

/**
 * Keeps the mark of a list in sight: scrolls when the mark or the list's size changes. It measures after the browser's own
 * layout for the next frame, because measuring earlier would force a second layout.
 */
export class Follower {
  private list: HTMLElement | null = null;
  private mark: HTMLElement | null = null;
  private above = 0;
  private readonly observer = new ResizeObserver(() => this.look());

  /** Follows a mark in a list whose top is covered to the height `above`. */
  follow(list: HTMLElement | null, mark: HTMLElement | null, above = 0): void {
    const { observer } = this;
    this.above = above;
    if (list !== this.list) {
      observer.disconnect();
      if (list !== null) observer.observe(list);
      this.list = list;
    } else if (mark === this.mark) return;
    this.mark = mark;
    // The observer reports a newly observed element at once.
    if (mark !== null) observer.observe(mark);
  }

  private look(): void {
    const { list, mark, observer } = this;
    if (mark === null || list === null) return;
    observer.unobserve(mark);
    bringInSight(list, mark, this.above);
  }
}
