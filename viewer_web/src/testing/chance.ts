/** Pseudorandom numbers below `n`, by the generator of Park and Miller. */
export function chance(seed: number): (n: number) => number {
  let now = seed;
  return (n) => {
    now = (now * 48_271) % 2_147_483_647;
    return now % n;
  };
}
