import { columnsOf, takes } from '../i18n/en/phrases.js';
import type { Sentences } from '../language/texts.js';
import { cells, listed, point, short, shortApart, signed, windowText } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { Event, WarnockEvents } from '../trace/events.js';
import type { N } from '../trace/values.js';
import { containment, hidingOf, onlyOf, ownersOf, placeOf, sideAlong } from './naming.js';
import type { SideLine } from './naming.js';

const lists = { surrounding: 'surrounding', outside: 'outside' } as const;
const found = { surrounding: 'surround', outside: 'lie outside' } as const;

const rows = { one: 'row', other: 'rows' };
const vertices = { one: 'vertex', other: 'vertices' };

const colorOf = (event: Event<'fill'>, words: Words): string => {
  const { polygons, background } = ownersOf(event, words.after, words.header);
  if (polygons.length === 0) return background ? 'the background' : `the colour ${event.color}`;
  if (polygons.length === 1 && !background) return `the colour of ${polygons.join('')}`;
  return `the colour that ${listed([...polygons, ...(background ? ['the background'] : [])], 'and')} share`;
};

const place = (at: readonly (number | string)[], words: Words): string => {
  const corner = placeOf(at, words);
  return corner === null ? `point ${point(at)}` : `${corner} corner`;
};

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

/** How a point is called whose side of an edge is asked for, with its corner of the window if it is one. */
const sideOf: Readonly<Record<SideLine, (at: readonly N[], corner: string | null) => string>> = {
  TF2: (at, corner) => `The ${corner === null ? `point ${point(at)}` : `${corner} corner`}`,
  CR4: () => 'The centre of the window, where the ray begins,',
  OA4: (at, corner) =>
    `The ${corner === null ? `point ${point(at)}` : `${corner} corner`} of the window`,
  BF1: () => 'The vertex after it',
};

export const sentences: Pick<Sentences, keyof WarnockEvents | 'depth'> = {
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `At the ${place(at, words)} ${line === 'PC3' ? polygon : `the plane of ${polygon}`} has depth ${short(z)}.`,
  push: ({ at, window, shared, apl }, words) => {
    if (at === 'W3' || at === 'WS1' || at === 'WF1') {
      return `The first window, ${windowText(window)}, goes on the stack with ${words.ids((apl ?? []).map(([id]) => id)) || 'no polygon'}.`;
    }
    if (at === 'WF12') return `The part ${windowText(window)} goes on the stack.`;
    const list = shared === true ? 'the same list' : 'its own copy of the list';
    return `The part ${windowText(window)} goes on the stack with ${list}.`;
  },
  skip: ({ window }) => `The part ${windowText(window)} lies outside the area: it is skipped.`,
  pop: ({ at, window }, words) => {
    const taken = `The window ${windowText(window)} comes off the stack`;
    if (at === 'WF2') {
      return `${taken}: it is of level ${words.after.warnock?.way?.length ?? 0}.`;
    }
    if (words.header.detail === 'windows') return `${taken}.`;
    return `${taken} with ${currentList(words) || 'an empty list'}.`;
  },
  corners: ({ z }) => `Nothing is seen yet: the depth at all four corners starts at ${short(z)}.`,
  box: ({ polygon, outside }) =>
    outside
      ? `The box of ${polygon} lies outside the window.`
      : `The box of ${polygon} meets the window.`,
  discard: ({ polygon }) => `${polygon} is not counted in this window: it leaves the list.`,
  count: ({ polygon, count }) =>
    `${polygon} is counted in this window: polygonCount is now ${count}.`,
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
        ? `The box of ${polygon}, the first that is counted, lies strictly inside the window.`
        : `The box of ${polygon}, the first that is counted, does not lie strictly inside the window.`,
  summary: ({ count, hasSurround }, words) => {
    const found = words.counted(count, { one: 'polygon', other: 'polygons' });
    const one = words.after.warnock?.covering ?? 'one';
    return `${found} counted in the window; ${hasSurround ? `${one} hides all others` : 'none is known to hide the others'}.`;
  },
  decide: (event, { after }) => {
    const only = onlyOf(after);
    const covering = hidingOf(after) ?? 'One polygon';
    return {
      empty: 'No polygon is left in the window: it takes the background.',
      surrounded: `${covering} hides everything: the window takes its colour.`,
      pixel: 'The window is no larger than a pixel: the point at its centre decides.',
      single: `Only ${only ?? 'one polygon'} is left in the window: background first, then ${only ?? 'the polygon'}.`,
      split: 'None of the simple cases: the window is split.',
    }[event.case];
  },
  fill: (event, words) =>
    `${takes(event.rect[2] * event.rect[3], words)} ${colorOf(event, words)}.`,
  nearest: ({ polygon, z }) => `${polygon} is the nearest at the point so far: z = ${short(z)}.`,
  color: (event, words) => {
    const { polygons, background } = ownersOf(event, words.after, words.header);
    const seen = polygons.join(' / ') || (background ? 'the background' : event.color);
    return `At ${point(event.point)} one sees ${seen}.`;
  },
  orient: ({ at, polygon, edge, point: where, value, sign }, words) => {
    const name = at === 'S2' || at === 'S3' || at === 'ED3' ? null : sideOf[at];
    const what = name === null ? 'The point' : name(where, placeOf(where, words));
    const side = {
      '-1': 'on the negative side of',
      0: 'on the line of',
      1: 'on the positive side of',
    };
    return `${what} lies ${side[sign]} edge ${edge} of ${polygon} (${short(value)}).`;
  },
  clip_begin: ({ polygon }) => `${polygon} is clipped by the window's four sides in turn.`,
  clip_side: (event, { after }) => {
    const along = sideAlong(event, after.warnock?.window ?? null);
    const which = along === null ? '' : `, the ${along} one`;
    return `Side ${event.side} of 4${which}: the new list is empty.`;
  },
  clip_sign: ({ vertex, sign }) => {
    const where = {
      '-1': 'on the negative side of this line and counts as inside',
      0: 'on this line and counts as inside',
      1: 'on the positive side of this line and counts as outside',
    }[sign];
    return `The vertex ${point(vertex.slice(0, 2))} lies ${where}.`;
  },
  clip_cross: ({ vertex }) =>
    `The edge crosses the side at ${point(vertex.slice(0, 2))}: the crossing joins the new list.`,
  clip_keep: ({ vertex }) => `The vertex ${point(vertex.slice(0, 2))} joins the new list.`,
  clip_drop: ({ vertex }) =>
    `The vertex ${point(vertex.slice(0, 2))} counts as outside and is dropped.`,
  clip_list: ({ count }, words) =>
    count === 0
      ? 'Nothing is left.'
      : `This side is done: ${words.counted(count, vertices)} in the list.`,
  clip_result: ({ polygon, vertices: left }, words) =>
    left.length === 0
      ? `Clipping leaves nothing of ${polygon}.`
      : `Clipping leaves a part of ${polygon} with ${words.counted(left.length, vertices)}.`,
  row: ({ row, left, right, first, end }, { after }) => {
    const met = onlyOf(after) ?? 'the polygon';
    const where = first < end ? columnsOf(first, end - 1) : 'no pixel’s centre';
    return `Row ${short(row)} meets ${met} from ${short(left)} to ${short(right)}: ${where}.`;
  },
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} the colour of ${polygon}, in ${words.counted(runs.length, rows)}.`,

  back_face: ({ polygon, away }) =>
    away
      ? `${polygon} goes round clockwise: it looks away from the viewer and does not take part.`
      : `${polygon} goes round counter-clockwise: it looks towards the viewer and takes part.`,
  rejoin: ({ polygon, list, level }) =>
    `${polygon} was found to ${found[list]} a window of level ${level}, and this window is not part of that one: it goes back to the third list.`,
  join: ({ polygon, list, level }) =>
    `${polygon} joins the ${lists[list]} polygons at level ${level}: it is so for all parts of this window.`,
  relation: ({ polygon, relation }) =>
    ({
      outside: `${polygon} lies outside the window.`,
      inside: `${polygon} lies wholly inside the window.`,
      intersecting: `${polygon} intersects the window: an edge meets it.`,
      surrounding: `${polygon} surrounds the window.`,
    })[relation],
  trial: ({ polygon, edge, meets }) =>
    `Edge ${edge} of ${polygon} ${meets ? 'meets' : 'does not meet'} the window.`,
  meets: ({ polygon, meets }) =>
    meets
      ? `An edge of ${polygon} meets the window.`
      : `No edge of ${polygon} meets the window: it surrounds the window, or lies outside.`,
  ray: ({ at, edge, counts }, { after, header }) => {
    const so = `${containment(after.warnock)} so far`;
    if (at === 'CR4') {
      return counts === 1
        ? `Edge ${edge} crosses the ray: ${so}.`
        : `Edge ${edge} passes to the left of where the ray begins: ${so}.`;
    }
    if (counts > 0 && header.edition === 'vertex-counted-twice') {
      return `The beginning of edge ${edge} lies on the ray, which counts two here, touched or pierced: ${so}.`;
    }
    const where = `The beginning of edge ${edge} lies on the ray, where the outline`;
    if (counts === 2) return `${where} touches it, which counts two: ${so}.`;
    if (counts === 1) return `${where} pierces it, which counts one: ${so}.`;
    return `The beginning of edge ${edge} lies to the left of where the ray begins: ${so}.`;
  },
  crossings: ({ polygon, count }, words) =>
    `The outline of ${polygon} crosses the ray ${words.counted(count, { one: 'time', other: 'times' })}: ${count % 2 === 1 ? 'odd, so it surrounds the window' : 'even, so it lies outside'}.`,
  octants: ({ at, edge, from, to, difference }, { after }) => {
    const way = `Edge ${edge} goes from octant ${from} to octant ${to}`;
    const sum = signed(containment(after.warnock));
    return at === 'OA4'
      ? `${way}, the opposite one: split by a side of the window it turns by ${signed(difference)}; the sum is ${sum}.`
      : `${way}: ${signed(difference)}; the sum is ${sum}.`;
  },
  angle: ({ polygon, octants }) =>
    octants === 0
      ? `The turns of ${polygon} cancel: the sum is 0 octants, so it lies outside the window.`
      : `${polygon} goes round the window: the sum is ${signed(octants)} octants, so it surrounds the window.`,
  hiding: ({ polygon }) =>
    polygon === undefined
      ? 'No surrounding polygon is known to hide all others.'
      : `${polygon} surrounds the window and lies before all others: it hides them.`,
  split_vertex: ({ polygon, vertex, column, row, splits }) =>
    splits
      ? `Vertex ${vertex} of ${polygon} lies in the window, which is split next to it, at x = ${short(column)}, y = ${short(row)}.`
      : `Vertex ${vertex} of ${polygon} lies in the window, but next to it, at x = ${short(column)}, y = ${short(row)}, there is nothing to split.`,
  edge_depth: ({ polygon, edge, z }) =>
    `${polygon} is seen edge-on; its edge ${edge} has depth ${short(z)} at the point.`,
};
