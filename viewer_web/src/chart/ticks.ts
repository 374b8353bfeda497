/** The multiples within decades at which an axis has numbers, finest first: parts of each decade, then fewer decades. */
const parts: readonly (readonly number[])[] = [
  [1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9],
  [1, 1.5, 2, 3, 4, 5, 7],
  [1, 2, 5],
  [1, 3],
  [1],
];
const decadeSteps = [2, 3, 5, 10, 20, 50, 100] as const;

function numbersOf(
  [least, greatest]: readonly [number, number],
  mantissas: readonly number[],
  step: number,
): readonly number[] {
  const first = Math.floor(Math.log10(least) / step) * step;
  const last = Math.ceil(Math.log10(greatest));
  const found: number[] = [];
  for (let exponent = first; exponent <= last; exponent += step) {
    // Parsed from text, because 3 * 10 ** -5 is not 3e-5.
    for (const mantissa of mantissas) found.push(Number(`${mantissa}e${exponent}`));
  }
  return found.filter((number) => number > 0 && number >= least && number <= greatest);
}

/** The most ticks of a logarithmic axis of this length that leave at least `gap` between them. */
export function logTicks(
  domain: readonly [number, number],
  length: number,
  gap: number,
): readonly number[] {
  const [least, greatest] = domain;
  const scale = length / (Math.log10(greatest) - Math.log10(least));
  const apart = (numbers: readonly number[]): boolean =>
    numbers.every((number, i) => {
      const before = numbers[i - 1];
      return before === undefined || Math.log10(number / before) * scale >= gap;
    });
  const choices = [
    ...parts.map((mantissas) => numbersOf(domain, mantissas, 1)),
    ...decadeSteps.map((step) => numbersOf(domain, [1], step)),
  ];
  return choices.find(apart) ?? [];
}
