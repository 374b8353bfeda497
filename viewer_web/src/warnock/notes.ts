import type { Numbers } from '../language/texts.js';
import { half, nearer, signOf } from '../listing/notation.js';
import type { Notes } from '../listing/notes.js';
import type { WarnockEvents } from '../trace/events.js';
import type { Box, N } from '../trace/values.js';

const vertexOf = ({ vertex }: { readonly vertex: readonly N[] }, { point }: Numbers): string =>
  point(vertex);
const windowOf = ({ window }: { readonly window: Box }, { windowText }: Numbers): string =>
  windowText(window);

/** The notes of the events of Warnock's algorithm and of its variants, in the notation of the listing. */
export const notes: Pick<Notes, keyof WarnockEvents> = {
  push: windowOf,
  skip: windowOf,
  pop: windowOf,
  corners: ({ z }, { short }) => `z = ${short(z)}`,
  box: ({ outside }) => String(outside),
  discard: ({ polygon }) => `− ${polygon}`,
  count: ({ count }) => String(count),
  compare: ({ z, against, nearer: is }, numbers) => nearer(z, against, is, numbers),
  nearer: ({ k }) => `k = ${k}`,
  uncover: () => 'false',
  surround: ({ inside }) => String(inside),
  mark: () => 'true',
  cover: ({ polygon }) => `true, ${polygon}`,
  insider: ({ inside }) => String(inside),
  summary: ({ count, hasSurround, insider }) => `${count}, ${hasSurround}, ${insider}`,
  decide: () => 'true',
  fill: ({ rect: [, , width, height] }) => `${width} × ${height}`,
  nearest: ({ polygon, z }, { short }) => `${polygon}: ${short(z)}`,
  color: ({ color }) => color,
  orient: signOf,
  clip_begin: ({ polygon }) => polygon,
  clip_side: ({ side }) => `i = ${side}`,
  clip_sign: signOf,
  clip_cross: vertexOf,
  clip_keep: vertexOf,
  clip_drop: (event, numbers) => `− ${vertexOf(event, numbers)}`,
  clip_list: ({ count }) => `|P′| = ${count}`,
  clip_result: ({ vertices }) => `|P′| = ${vertices.length}`,
  row: ({ first, end }, numbers) => half([first, end], numbers),
  draw: ({ polygon }) => polygon,

  back_face: ({ away }) => String(away),
  rejoin: ({ polygon, level }) => `${polygon}, ${level}`,
  join: ({ polygon, level }) => `${polygon}, ${level}`,
  relation: null,
  trial: ({ meets }) => String(meets),
  meets: ({ meets }) => String(meets),
  ray: ({ counts }) => `+ ${counts}`,
  crossings: ({ count }) => `n = ${count}`,
  octants: ({ from, to, difference }, { signed }) => `${from} → ${to}: ${signed(difference)}`,
  angle: ({ octants }, { signed }) => `S = ${signed(octants)}`,
  hiding: ({ polygon }) => polygon ?? '∅',
  split_vertex: ({ column, row }) => `${column}, ${row}`,
  edge_depth: ({ edge, z }, { short }) => `${edge}: ${short(z)}`,
};
