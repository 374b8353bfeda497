import { pictureRows } from '../replay/canonical.js';
import { ValueInHand, defineModel } from '../replay/model.js';
import type { Screen } from '../replay/screen.js';
import type { Detail } from '../trace/events.js';
import { effects, emptyZBuffer } from './state.js';
import type { ZBuffer } from './state.js';

function values({ polygon, edges, ael, last }: ZBuffer): object {
  const { y, row, nextS, nextAel } = last;
  return {
    polygon,
    S: edges,
    ael: ael.map(({ edge, x, z, until, dx, dz }) => ({ edge, x, z, until, dx, dz })),
    y,
    row,
    nextS,
    nextAel,
  };
}

function depthRows({ z }: Screen, detail: Detail): unknown {
  if (z === null || detail === 'windows') return null;
  return Array.from({ length: z.height }, (_, j) => Array.from(z.row(j)));
}

defineModel(['zbuffer'], {
  begin: () =>
    new ValueInHand('zbuffer', emptyZBuffer, (event, now, { screen }) =>
      effects.after(event, now, screen),
    ),
  uses: effects.uses,
  compared: ({ held: { zbuffer = emptyZBuffer }, screen, detail }) => ({
    picture: pictureRows(screen),
    warnock: null,
    zbuffer: { ...values(zbuffer), z: depthRows(screen, detail) },
  }),
});
