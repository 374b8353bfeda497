export const why = {
  title: 'Why, for each polygon',
  others: (n: number): string => `and ${n} others that do not hold the centre`,
  more: (n: number): string => `${n} more`,
  /** What is drawn beside the sentences, for screen readers. */
  depths: (all: string): string => `Depths at the centre, the nearest on top: ${all}`,
  nearer: 'nearer',
};
