import type { Size } from './frame.js';

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

/** Keeps what is marked in a list in sight. */
export class Follower {
  private list: List | null = null;
  private mark: Mark | null = null;
  private size: Size | null = null;

  /** To look where the mark is makes the browser lay out the page: only when it is another, or the list's size is. */
  follow(list: List | null, mark: Mark | null, size: Size, above = 0): void {
    if (list === this.list && mark === this.mark && size === this.size) return;
    Object.assign(this, { list, mark, size });
    if (list !== null && mark !== null) bringInSight(list, mark, above);
  }
}
