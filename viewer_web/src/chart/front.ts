interface Place {
  readonly cost: number;
  readonly error: number;
}

export function byCost(a: Place, b: Place): number {
  return a.cost - b.cost || byError(a, b);
}

/** Errors may be infinite, so that their difference is no number. */
export function byError(a: Place, b: Place): number {
  if (a.error === b.error) return a.cost - b.cost;
  return a.error < b.error ? -1 : 1;
}

/** Those for which no other is better in cost or error, and as good in the other; of equal ones the first. */
export function frontOf<T extends Place>(places: readonly T[]): ReadonlySet<T> {
  const front = new Set<T>();
  let last: Place | null = null;
  for (const place of [...places].sort(byCost)) {
    if (last !== null && place.error >= last.error) continue;
    last = place;
    front.add(place);
  }
  return front;
}
