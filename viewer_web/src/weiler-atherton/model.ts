import { pictureRows } from '../replay/canonical.js';
import { ValueInHand, defineModel } from '../replay/model.js';
import { afterRegions, emptyRegions } from './state.js';
import type { Regions } from './state.js';
import { uses } from './uses.js';

const values = ({ lists, inHand, facets, visible }: Regions): object => ({
  lists,
  list: inHand && { pieces: inHand.pieces, inside: inHand.inside, outside: inHand.outside },
  facets,
  visible,
});

defineModel(['weiler-atherton'], {
  begin: () =>
    new ValueInHand('regions', emptyRegions, (event, now, { screen }) =>
      afterRegions(event, now, screen),
    ),
  uses,
  compared: ({ held: { regions = emptyRegions }, screen }) => ({
    picture: pictureRows(screen),
    warnock: null,
    zbuffer: null,
    weilerAtherton: values(regions),
  }),
});
