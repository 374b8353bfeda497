/**
 * How far below the top of the visible part of a text its reader is: at a third; at first less and at last more, so that
 * the line passes all of the text, the beginning and the end too. All in pixels: how far one has scrolled and can at
 * most, and the height of what is visible.
 */
export function readingLine(scrolled: number, most: number, height: number): number {
  if (most <= 0) return 0;
  const third = height / 3;
  const first = Math.min(third, most / 3);
  const last = Math.min(2 * third, (2 * most) / 3);
  if (scrolled < first) return (third * scrolled) / first;
  const over = scrolled - (most - last);
  return over > 0 ? third + (2 * third * over) / last : third;
}

/** How far one scrolls for the line to be at a place, so many pixels below the beginning of the text. */
export function scrolledTo(place: number, most: number, height: number): number {
  let [low, high] = [0, Math.max(0, most)];
  while (high - low > 0.25) {
    const middle = (low + high) / 2;
    if (middle + readingLine(middle, most, height) < place) low = middle;
    else high = middle;
  }
  return high;
}
