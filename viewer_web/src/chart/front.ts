interface Place {
  readonly cost: number;
  readonly error: number;
}

export function byCost(a: Place, b: Place): number {
  return a.cost - b.cost || byError(a, b);
}

/** Compares errors. They may be infinite, so their difference may be NaN. */
export function byError(a: Place, b: Place): number {
  if (a.error === b.error) return a.cost - b.cost;
  return a.error < b.error ? -1 : 1;
}

/** The places that no other one beats in cost or error while at least as good in the other; the first of equal ones. */
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
