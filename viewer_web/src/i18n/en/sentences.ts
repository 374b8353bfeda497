import type { Sentences } from '../texts.js';
import { cells, hidingOf, onlyOf, point, short, shortApart, windowText } from '../words.js';
import type { Words } from '../words.js';
import { curveSentences } from './curves.js';
import { exact } from './exact.js';
import { family } from './family.js';
import { isOpenOutline } from '../../regions/events.js';
import { regionSentences } from './regions.js';
import { purposes } from './page.js';

const pixels = { one: 'pixel', other: 'pixels' };
const rows = { one: 'row', other: 'rows' };
const vertices = { one: 'vertex', other: 'vertices' };

const takes = (n: number, words: Words): string =>
  `${words.counted(n, pixels)} ${n === 1 ? 'takes' : 'take'}`;

const colorOf = (color: string, words: Words): string => {
  const owner = words.owner(color);
  return owner === null ? 'the background' : `the colour of ${owner}`;
};

const place = (at: readonly (number | string)[], words: Words): string => {
  const corner = words.placeOf(at);
  return corner === null ? `point ${point(at)}` : `${corner} corner`;
};

/** "1", "1 and 0", "2, 1 and 0". */
const allOf = (list: readonly number[]): string =>
  [list.slice(0, -1).join(', '), list.slice(-1).join()].filter(Boolean).join(' and ');

const edgesOf = (list: readonly number[]): string =>
  `${list.length === 1 ? 'Edge' : 'Edges'} ${allOf(list)}`;

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

const sides = ['top', 'left', 'bottom', 'right'];
const when = (next: number | string, before: string): string =>
  next === 'inf' ? '' : `; ${before} ${short(next)}`;

const { answer, causes, decided } = exact;

export const sentences: Sentences = {
  plane: ({ polygon, plane }) =>
    `The plane of ${polygon}: a, b, c, d = ${plane.map(short).join(', ')}.`,
  call: ({ of }) => `${of} begins: ${purposes[of]}`,
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `At the ${place(at, words)} ${line === 'PC3' ? polygon : `the plane of ${polygon}`} has depth ${short(z)}.`,
  fault: ({ at, reason, x, y }) => {
    if (isOpenOutline(at)) {
      return 'An outline does not close here, by rounding: what cannot be closed is left out, and the run goes on.';
    }
    return x === undefined || y === undefined
      ? `The printed text fails here: ${reason}. The run ends.`
      : `The printed text fails here: ${reason}, pixel (${x}, ${y}).`;
  },
  disagree: ({ of, taken, exact, cause }) =>
    `Wrong, ${decided[of]}: computed ${answer(taken)}, exactly ${answer(exact)}. ${causes[cause]}`,

  push: ({ at, window, shared, apl }, words) => {
    if (at === 'W3' || at === 'WS1' || at === 'WF1') {
      return `The first window, ${windowText(window)}, goes on the stack with ${words.ids((apl ?? []).map(([id]) => id)) || 'no polygon'}.`;
    }
    if (at === 'WF12') return `The part ${windowText(window)} goes on the stack.`;
    const list = shared === true ? 'the same list' : 'its own copy of the list';
    return `The part ${windowText(window)} goes on the stack with ${list}.`;
  },
  skip: ({ window }) => `The part ${windowText(window)} lies outside the area: it is skipped.`,
  pop: ({ at, window }, words) =>
    at === 'WF2'
      ? `The window ${windowText(window)} comes off the stack: it is of level ${words.after.warnock?.way?.length ?? 0}.`
      : `The window ${windowText(window)} comes off the stack with ${currentList(words) || 'an empty list'}.`,
  corners: ({ z }) => `Nothing is seen yet: the depth at all four corners starts at ${short(z)}.`,
  box: ({ polygon, outside }) =>
    outside
      ? `The box of ${polygon} lies outside the window.`
      : `The box of ${polygon} meets the window.`,
  discard: ({ polygon }) => `${polygon} cannot show in this window: it leaves the list.`,
  count: ({ polygon, count }) =>
    `${polygon} may show in this window: polygonCount is now ${count}.`,
  compare: ({ polygon, corner, z, against, nearer }, words) => {
    const where = corner === undefined ? 'At the point' : `At the ${words.places([corner])}`;
    const sign = nearer ? '>' : '≯';
    const so = nearer ? 'is nearer' : 'is not nearer';
    return `${where} ${polygon} ${so}: ${shortApart(z, against).join(` ${sign} `)}.`;
  },
  nearer: ({ polygon, corners, k }, words) => {
    if (k === 0) return `${polygon} is nearer at none of the 4 corners.`;
    const where = k === 4 ? '' : ` (${words.places(corners)})`;
    return `${polygon} is nearer at ${k} of 4 corners${where}.`;
  },
  uncover: ({ polygon }, { before }) => {
    const hidden = before.warnock?.covering ?? null;
    return hidden === null
      ? `${polygon} is nearer somewhere: for now nothing is known to hide everything.`
      : `${polygon} is nearer somewhere, so ${hidden} no longer hides everything.`;
  },
  surround: ({ polygon, point: at, inside }, words) =>
    `The ${place(at, words)} lies ${inside ? 'in' : 'outside'} ${polygon}.`,
  mark: ({ polygon }) => `All four corners lie in ${polygon}: it surrounds the window.`,
  cover: ({ polygon }) =>
    `${polygon} surrounds the window and is nearest at all four corners: it hides all so far.`,
  insider: ({ at, polygon, inside }) =>
    at === 'RE2'
      ? `The box of ${polygon} ${inside ? 'lies' : 'does not lie'} strictly inside the window.`
      : inside
        ? `${polygon}, the first in the window, lies wholly inside it.`
        : `${polygon}, the first in the window, does not lie wholly inside it.`,
  summary: ({ count, hasSurround }, words) => {
    const found = words.counted(count, { one: 'polygon', other: 'polygons' });
    const one = words.after.warnock?.covering ?? 'one';
    return `${found} in the window; ${hasSurround ? `${one} hides all others` : 'none is known to hide the others'}.`;
  },
  decide: (event, { after }) => {
    const only = onlyOf(after);
    const covering = hidingOf(after) ?? 'One polygon';
    return {
      empty: 'No polygon is left in the window: it takes the background.',
      surrounded: `${covering} hides everything: the window takes its colour.`,
      pixel: 'The window is no larger than a pixel: the point at its centre decides.',
      single: `Only ${only ?? 'one polygon'} is in the window: background first, then ${only ?? 'the polygon'}.`,
      split: 'None of the simple cases: the window is split.',
    }[event.case];
  },
  fill: ({ rect, color }, words) => `${takes(rect[2] * rect[3], words)} ${colorOf(color, words)}.`,
  nearest: ({ polygon, z }) => `${polygon} is the nearest at the point so far: z = ${short(z)}.`,
  color: ({ point: at, color }, words) =>
    `At ${point(at)} one sees ${words.owner(color) ?? 'the background'}.`,
  orient: ({ at, polygon, edge, point: where, value, sign }, words) => {
    const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : family.side[at];
    const what = name === null ? 'The point' : name(where, words.placeOf(where));
    const side = {
      '-1': 'on the negative side of',
      0: 'on the line of',
      1: 'on the positive side of',
    };
    return `${what} lies ${side[sign]} edge ${edge} of ${polygon} (${short(value)}).`;
  },
  clip_begin: ({ polygon }) => `${polygon} is clipped by the window's four sides in turn.`,
  clip_side: ({ side }) =>
    `Side ${side} of 4, the ${sides[side - 1] ?? ''} one: the new list is empty.`,
  clip_sign: ({ vertex, sign }) => {
    const where = { '-1': 'on the inner side of', 0: 'on', 1: 'on the outer side of' }[sign];
    return `The vertex ${point(vertex.slice(0, 2))} lies ${where} this side.`;
  },
  clip_cross: ({ vertex }) =>
    `The edge crosses the side at ${point(vertex.slice(0, 2))}: the crossing joins the new list.`,
  clip_keep: ({ vertex }) => `The vertex ${point(vertex.slice(0, 2))} joins the new list.`,
  clip_drop: ({ vertex }) => `The vertex ${point(vertex.slice(0, 2))} lies outside and is dropped.`,
  clip_list: ({ count }, words) =>
    count === 0
      ? 'Nothing is left.'
      : `This side is done: ${words.counted(count, vertices)} in the list.`,
  clip_result: ({ polygon, vertices: left }, words) =>
    left.length === 0
      ? `No part of ${polygon} lies in the window.`
      : `The part of ${polygon} in the window has ${words.counted(left.length, vertices)}.`,
  row: ({ row, left, right, first, end }) =>
    first < end
      ? `Row ${row} meets the polygon from ${short(left)} to ${short(right)}: columns ${first} to ${end - 1}.`
      : `Row ${row} meets the polygon from ${short(left)} to ${short(right)}: no pixel's centre.`,
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} the colour of ${polygon}, in ${words.counted(runs.length, rows)}.`,

  ...family.sentences,

  clear: ({ z }) => `The picture is all background; every cell of the Z-buffer holds ${short(z)}.`,
  polygon: ({ polygon }) => `Next polygon: ${polygon}. S and the AEL are empty.`,
  edge: ({ edge, rows }) => {
    const [first, last] = rows ?? [];
    if (first === undefined || last === undefined) return `Edge ${edge} joins S.`;
    if (last < first) return `Edge ${edge} joins S; it crosses the centre of no row.`;
    return `Edge ${edge} joins S: rows ${first} to ${last}.`;
  },
  extent: ({ ymin, ymax }) => `The polygon reaches from y = ${short(ymin)} to ${short(ymax)}.`,
  scanline: ({ y, row }) => `The scanline is row ${row}, y = ${short(y)}.`,
  ael_add: ({ edge, x, z, until }) =>
    `Edge ${edge} begins: it joins the AEL at x = ${short(x)}, z = ${short(z)}, until ${short(until)}.`,
  horizontal: ({ edge }) =>
    `Edge ${edge} is horizontal: it is drawn at once and does not join the AEL.`,
  leave: ({ edges, next }) =>
    edges.length === 0
      ? 'No edge leaves S.'
      : `${edgesOf(edges)} ${edges.length === 1 ? 'leaves' : 'leave'} S${when(next, 'the next begins at')}.`,
  ael_sort: ({ edges, next }, words) =>
    edges.length === 0
      ? 'The AEL is empty.'
      : `The AEL from left to right: ${words.list(edges)}${when(next, 'the next change is at')}.`,
  line: ({ row, from, to }) =>
    `Row ${row} from x = ${short(from[0])} (z = ${short(from[1])}) to x = ${short(to[0])} (z = ${short(to[1])}).`,
  miss: () => 'The segment lies outside the area: nothing to show.',
  slope: ({ dz }) => `From pixel to pixel z changes by ${short(dz)}.`,
  columns: ({ first, end, z }) =>
    first < end
      ? `Columns ${first} to ${end - 1}: z = ${short(z)} at the first.`
      : 'No pixel centre lies between the ends.',
  pixel: ({ x, y, z, stored, shown }) => {
    const [depth, before] = shortApart(z, stored);
    return shown
      ? `Pixel (${x}, ${y}): ${depth} is nearer than ${before}, so it shows.`
      : `Pixel (${x}, ${y}): ${depth} is not nearer than ${before}, so it stays hidden.`;
  },
  span: ({ row, runs }, words) =>
    cells(runs) === 0
      ? `No pixel of row ${row} changes.`
      : `${takes(cells(runs), words)} the colour of ${words.after.zbuffer?.polygon ?? ''}, in row ${row}.`,
  ael_drop: ({ edges, next }) =>
    edges.length === 0
      ? 'No edge ends here.'
      : `${edgesOf(edges)} ${edges.length === 1 ? 'ends here and leaves' : 'end here and leave'} the AEL${when(next, 'the next change is at')}.`,
  ael_step: ({ edge, x, z }) => `Edge ${edge} steps to x = ${short(x)}, z = ${short(z)}.`,

  ...curveSentences,
  ...regionSentences,
};
