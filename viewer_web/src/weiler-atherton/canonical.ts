import type { Regions } from './state.js';

/** The values of the state in the form in which readers of a trace are compared. */
export const regionValues = ({ lists, inHand, facets, visible }: Regions): object => ({
  lists,
  list: inHand && { pieces: inHand.pieces, inside: inHand.inside, outside: inHand.outside },
  facets,
  visible,
});
