/** What of a list the follower looks at. */
type List = Pick<HTMLElement, 'scrollTop' | 'clientHeight'>;
type Mark = Pick<HTMLElement, 'offsetTop' | 'offsetHeight'>;

/** Scrolls a list within itself, only if what is marked in it is out of sight, to a third of its height. */
export function bringInSight(list: List, mark: Mark, above = 0): void {
  const { offsetTop: top, offsetHeight: height } = mark;
  const hidden =
    top - above < list.scrollTop || top + 2 * height > list.scrollTop + list.clientHeight;
  if (hidden) list.scrollTop = top - list.clientHeight / 3;
}

/**
 * Keeps what is marked in a list in sight: scrolls when the mark is another, or the list's size. It looks when the browser has laid
 * out the page for the next frame, as to look earlier would have it do so twice.
 */
export class Follower {
  private list: HTMLElement | null = null;
  private mark: HTMLElement | null = null;
  private above = 0;
  private readonly observer = new ResizeObserver(() => this.look());

  /** So much at the top of the list covers what is there. */
  follow(list: HTMLElement | null, mark: HTMLElement | null, above = 0): void {
    const { observer } = this;
    this.above = above;
    if (list !== this.list) {
      observer.disconnect();
      if (list !== null) observer.observe(list);
      this.list = list;
    } else if (mark === this.mark) return;
    this.mark = mark;
    // What is observed anew is told of at once.
    if (mark !== null) observer.observe(mark);
  }

  private look(): void {
    const { list, mark, observer } = this;
    if (mark === null || list === null) return;
    observer.unobserve(mark);
    bringInSight(list, mark, this.above);
  }
}
