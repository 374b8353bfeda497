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
 * Scrolls a list if a line or one of its neighbours is out of sight. If it fits, the list begins with the first of the lines,
 * or else with one that leaves room for the lines to come. `veiled` is the height at the list's end where text fades; it is used
 * where the neighbours need it.
 */
export function bringLineInSight(list: List, lines: readonly Mark[], at: number, veiled = 0): void {
  const line = lines[at];
  if (line === undefined) return;
  const { offsetTop: top } = lines[at - 1] ?? line;
  const { offsetTop, offsetHeight } = lines[at + 1] ?? line;
  const end = offsetTop + offsetHeight;
  const clear = list.clientHeight - veiled;
  const room = end - top <= clear ? clear : list.clientHeight;
  if (top >= list.scrollTop && end <= list.scrollTop + room) return;
  const fits = (first: Mark, i: number): boolean =>
    end - first.offsetTop <= (i === 0 ? room : (2 / 3) * room);
  const whole = end - top <= room ? top : line.offsetTop;
  list.scrollTop = lines.slice(0, at).find(fits)?.offsetTop ?? whole;
}

/**
 * Keeps the mark of a list in sight: scrolls when the mark or the list's size changes. It measures after the browser's own
 * layout for the next frame, because measuring earlier would force a second layout.
 */
export class Follower {
  private list: HTMLElement | null = null;
  private mark: HTMLElement | null = null;
  private above = 0;
  private step = 0;
  private lines: readonly HTMLElement[] = [];
  private readonly observer = new ResizeObserver(() => this.look());

  /**
   * Follows a mark in a list whose top is covered to the height `above`; if it is one of some lines, with its neighbours. At
   * another step it looks again, since a longer note above the mark may have moved it.
   */
  follow(
    list: HTMLElement | null,
    mark: HTMLElement | null,
    above = 0,
    lines: readonly HTMLElement[] = [],
    step = 0,
  ): void {
    const { observer } = this;
    this.above = above;
    this.lines = lines;
    if (list !== this.list) {
      observer.disconnect();
      if (list !== null) observer.observe(list);
      this.list = list;
    } else if (mark === this.mark && step === this.step) return;
    this.mark = mark;
    this.step = step;
    // The observer reports a newly observed element at once.
    if (mark !== null) observer.observe(mark);
  }

  private look(): void {
    const { list, mark, observer } = this;
    if (mark === null || list === null) return;
    observer.unobserve(mark);
    const at = this.lines.indexOf(mark);
    if (at < 0) bringInSight(list, mark, this.above);
    else
      bringLineInSight(
        list,
        this.lines,
        at,
        Number.parseFloat(getComputedStyle(list).scrollPaddingBottom) || 0,
      );
  }
}
