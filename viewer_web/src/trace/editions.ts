/** The usual mistakes, each in procedures that are else the corrected ones. */
const mistakes = [
  'one-list',
  'depths-not-cleared',
  'clip-order-reversed',
  'y-flipped',
  'depth-sign-reversed',
  'boundary-outside',
  'integer-division',
  'surround-kept',
  'vertex-counted-twice',
  'octants-not-split',
  'line-for-edge',
] as const;

export const editions = ['corrected', 'printed', ...mistakes] as const;

export type Mistake = (typeof mistakes)[number];
export type Edition = (typeof editions)[number];

export const isMistake = (edition: Edition): edition is Mistake =>
  mistakes.some((each) => each === edition);
