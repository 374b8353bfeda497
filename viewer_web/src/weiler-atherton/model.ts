import { pictureRows } from '../replay/canonical.js';
import { ValueInHand, defineModel } from '../replay/model.js';
import { effects, emptyWeilerAtherton } from './state.js';
import type { WeilerAtherton } from './state.js';

const values = ({ lists, inHand, facets, visible }: WeilerAtherton): object => ({
  lists,
  list: inHand && { pieces: inHand.pieces, inside: inHand.inside, outside: inHand.outside },
  facets,
  visible,
});

defineModel(['weiler-atherton'], {
  begin: () =>
    new ValueInHand('weilerAtherton', emptyWeilerAtherton, (event, now, { screen }) =>
      effects.after(event, now, screen),
    ),
  uses: effects.uses,
  compared: ({ held: { weilerAtherton = emptyWeilerAtherton }, screen }) => ({
    picture: pictureRows(screen),
    warnock: null,
    zbuffer: null,
    weilerAtherton: values(weilerAtherton),
  }),
});
