/**
 * The distance of the reading line from the top of the visible part of a text: a third of the height in the middle of the
 * text, less near its beginning and more near its end, so that the line passes the whole text. All in pixels: the scroll
 * position, its maximum, and the visible height.
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

/** The scroll position at which the line is at a place, given in pixels below the beginning of the text. */
export function scrolledTo(place: number, most: number, height: number): number {
  let [low, high] = [0, Math.max(0, most)];
  while (high - low > 0.25) {
    const middle = (low + high) / 2;
    if (middle + readingLine(middle, most, height) < place) low = middle;
    else high = middle;
  }
  return high;
}
