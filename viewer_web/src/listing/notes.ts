import { curveNotes } from '../floating-horizon/notes.js';
import type { Numbers } from '../language/texts.js';
import { orderOf, toNumber, withoutDoubledSigns } from '../language/words.js';
import { regionNotes } from '../weiler-atherton/notes.js';
import { plainOf } from '../trace/check.js';
import { details, eventsOf, isToldAnywhere, kinds } from '../trace/events.js';
import type { Detail, Event, EventName, Method } from '../trace/events.js';
import type { Answer, Box, N } from '../trace/values.js';

/** What an event says in the notation of the listing; null where that is nothing. */
type Note<K extends EventName> = ((event: Event<K>, numbers: Numbers) => string) | null;

const order: Readonly<Record<string, string>> = { '-1': '<', '0': '=', '1': '>' };
const signOf = (
  { value, sign }: { readonly value: N; readonly sign: number },
  { short }: Numbers,
): string => `${short(value)} ${order[sign] ?? ''} 0`;
const nearer = (z: N, against: N, is: boolean, { shortApart }: Numbers): string =>
  shortApart(z, against).join(is ? ' > ' : ' ≯ ');
/** The printed text shows what is as near, too, and nothing beyond 1. */
function shownBy({ z, stored, shown }: Event<'pixel'>, numbers: Numbers): string {
  const order = orderOf(z, stored);
  if (shown) return numbers.shortApart(z, stored).join(order === 0 ? ' ≥ ' : ' > ');
  return order === 1 && toNumber(z) > 1
    ? `${numbers.short(z)} > 1`
    : nearer(z, stored, false, numbers);
}
const vertexOf = ({ vertex }: { readonly vertex: readonly N[] }, { point }: Numbers): string =>
  point(vertex);
const windowOf = ({ window }: { readonly window: Box }, { windowText }: Numbers): string =>
  windowText(window);
const polygonOf = ({ polygon }: { readonly polygon: string }): string => polygon;
const edgeOf = ({ edge }: { readonly edge: number }): string => `e = ${edge}`;
const edgesOf = ({ edges }: { readonly edges: readonly number[] }): string =>
  edges.join(' ') || '∅';
const half = (range: readonly [first: number, end: number], { list }: Numbers): string =>
  `[${list(range)})`;

const answer = (value: Answer, numbers: Numbers): string =>
  typeof value === 'object' ? half(value, numbers) : String(value).replace('-', '−');

const notes: { readonly [K in EventName]: Note<K> } = {
  plane: ({ plane }, { point }) => point(plane),
  call: null,
  depth: ({ z }, { short }) => short(z),
  fault: ({ reason }) => reason,
  disagree: ({ taken, exact }, numbers) => `${answer(taken, numbers)} ≠ ${answer(exact, numbers)}`,

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
  clip_begin: polygonOf,
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

  clear: null,
  polygon: polygonOf,
  edge: edgeOf,
  extent: ({ ymin, ymax }, { list }) => list([ymin, ymax]),
  scanline: ({ y }, { short }) => `yₜ = ${short(y)}`,
  ael_add: edgeOf,
  horizontal: edgeOf,
  leave: edgesOf,
  ael_sort: edgesOf,
  line: ({ from, to }, { list }) => list([from[0], to[0]]),
  miss: () => 'true',
  slope: ({ dz }, { short }) => `Δz = ${short(dz)}`,
  columns: ({ first, end }, numbers) => half([first, end], numbers),
  pixel: shownBy,
  span: ({ runs }, numbers) => runs.map((run) => half(run, numbers)).join(' ') || '∅',
  ael_drop: edgesOf,
  ael_step: ({ edge, x }, { short }) => `${edge}: ${short(x)}`,

  ...curveNotes,
  ...regionNotes,
};

/** What an event says beside its line; null if nothing. */
export function noteOf(event: Event, numbers: Numbers): string | null {
  const note = notes[event.e] as Note<EventName>;
  return note === null ? null : withoutDoubledSigns(note(event, numbers));
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
