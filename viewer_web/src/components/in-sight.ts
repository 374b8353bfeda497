/** Scrolls a list within itself, only if what is marked in it is out of sight, to a third of its height. */
export function bringInSight(list: HTMLElement, mark: HTMLElement, above = 0): void {
  const { offsetTop: top, offsetHeight: height } = mark;
  const hidden =
    top - above < list.scrollTop || top + 2 * height > list.scrollTop + list.clientHeight;
  if (hidden) list.scrollTop = top - list.clientHeight / 3;
}
