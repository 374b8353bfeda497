import { curveNotes } from '../curves/notes.js';
import { orderOf, point, short, shortApart, toNumber, windowText } from '../i18n/words.js';
import { regionNotes } from '../regions/notes.js';
import { plainOf } from '../trace/check.js';
import { details, eventsOf, isToldAnywhere, kinds } from '../trace/events.js';
import type { Detail, Event, EventName, Method } from '../trace/events.js';
import type { Answer, Box, N } from '../trace/values.js';

/** What an event says in the notation of the listing, the same in any language; null where that is nothing. */
type Note<K extends EventName> = ((event: Event<K>) => string) | null;

const order: Readonly<Record<string, string>> = { '-1': '<', '0': '=', '1': '>' };
const signOf = ({ value, sign }: { readonly value: N; readonly sign: number }): string =>
  `${short(value)} ${order[sign] ?? ''} 0`;
const nearer = (z: N, against: N, is: boolean): string =>
  shortApart(z, against).join(is ? ' > ' : ' ≯ ');
/** The printed text shows what is as near, too, and nothing beyond 1. */
function shownBy({ z, stored, shown }: Event<'pixel'>): string {
  const order = orderOf(z, stored);
  if (shown) return shortApart(z, stored).join(order === 0 ? ' ≥ ' : ' > ');
  return order === 1 && toNumber(z) > 1 ? `${short(z)} > 1` : nearer(z, stored, false);
}
const vertexOf = ({ vertex }: { readonly vertex: readonly N[] }): string => point(vertex);
const windowOf = ({ window }: { readonly window: Box }): string => windowText(window);
const polygonOf = ({ polygon }: { readonly polygon: string }): string => polygon;
const edgeOf = ({ edge }: { readonly edge: number }): string => `e = ${edge}`;
const edgesOf = ({ edges }: { readonly edges: readonly number[] }): string =>
  edges.join(' ') || '∅';
const half = (first: number, end: number): string => `[${first}, ${end})`;

const signed = (n: number): string => (n > 0 ? `+${n}` : String(n).replace('-', '−'));

const answer = (value: Answer): string =>
  typeof value === 'object' ? half(...value) : String(value).replace('-', '−');

const notes: { readonly [K in EventName]: Note<K> } = {
  plane: ({ plane }) => point(plane),
  call: null,
  depth: ({ z }) => short(z),
  fault: ({ reason }) => reason,
  disagree: ({ taken, exact }) => `${answer(taken)} ≠ ${answer(exact)}`,

  push: windowOf,
  skip: windowOf,
  pop: windowOf,
  corners: ({ z }) => `z = ${short(z)}`,
  box: ({ outside }) => String(outside),
  discard: ({ polygon }) => `− ${polygon}`,
  count: ({ count }) => String(count),
  compare: ({ z, against, nearer: is }) => nearer(z, against, is),
  nearer: ({ k }) => `k = ${k}`,
  uncover: () => 'false',
  surround: ({ inside }) => String(inside),
  mark: () => 'true',
  cover: ({ polygon }) => `true, ${polygon}`,
  insider: ({ inside }) => String(inside),
  summary: ({ count, hasSurround, insider }) => `${count}, ${hasSurround}, ${insider}`,
  decide: () => 'true',
  fill: ({ rect: [, , width, height] }) => `${width} × ${height}`,
  nearest: ({ polygon, z }) => `${polygon}, ${short(z)}`,
  color: ({ color }) => color,
  orient: signOf,
  clip_begin: polygonOf,
  clip_side: ({ side }) => `i = ${side}`,
  clip_sign: signOf,
  clip_cross: vertexOf,
  clip_keep: vertexOf,
  clip_drop: (event) => `− ${vertexOf(event)}`,
  clip_list: ({ count }) => `|P′| = ${count}`,
  clip_result: ({ vertices }) => `|P′| = ${vertices.length}`,
  row: ({ first, end }) => half(first, end),
  draw: ({ polygon }) => polygon,

  back_face: ({ away }) => String(away),
  rejoin: ({ polygon, level }) => `${polygon}, ${level}`,
  join: ({ polygon, level }) => `${polygon}, ${level}`,
  relation: null,
  trial: ({ meets }) => String(meets),
  meets: ({ meets }) => String(meets),
  ray: ({ counts }) => `+ ${counts}`,
  crossings: ({ count }) => `n = ${count}`,
  octants: ({ from, to, difference }) => `${from} → ${to}: ${signed(difference)}`,
  angle: ({ octants }) => `S = ${signed(octants)}`,
  hiding: ({ polygon }) => polygon ?? '∅',
  split_vertex: ({ column, row }) => `${column}, ${row}`,
  edge_depth: ({ edge, z }) => `${edge}: ${short(z)}`,

  clear: null,
  polygon: polygonOf,
  edge: edgeOf,
  extent: ({ ymin, ymax }) => `${short(ymin)}, ${short(ymax)}`,
  scanline: ({ y }) => `yₜ = ${short(y)}`,
  ael_add: edgeOf,
  horizontal: edgeOf,
  leave: edgesOf,
  ael_sort: edgesOf,
  line: ({ from, to }) => `${short(from[0])}, ${short(to[0])}`,
  miss: () => 'true',
  slope: ({ dz }) => `Δz = ${short(dz)}`,
  columns: ({ first, end }) => half(first, end),
  pixel: shownBy,
  span: ({ runs }) => runs.map((run) => half(...run)).join(' ') || '∅',
  ael_drop: edgesOf,
  ael_step: ({ edge, x }) => `${edge}: ${short(x)}`,

  ...curveNotes,
  ...regionNotes,
};

/** What an event says beside its line; null if nothing. */
export function noteOf(event: Event): string | null {
  const note = notes[event.e] as Note<EventName>;
  return note?.(event) ?? null;
}

/** Whether a line of the method's listings ever has something beside it at this level. */
export function speaks(label: string, method: Method, detail: Detail): boolean {
  return eventsOf[method].some((name) => {
    const { at, from } = kinds[name];
    return (
      !isToldAnywhere(name) && // with what any line says by itself
      notes[name] !== null &&
      details.indexOf(from) <= details.indexOf(detail) &&
      new RegExp(`^${plainOf(at)}$`).test(`"${label}"`)
    );
  });
}
