import type { Event } from '../../trace/events.js';
import type { Sentences } from '../../language/texts.js';
import {
  cells,
  hidingOf,
  list,
  listed,
  onlyOf,
  point,
  short,
  shortApart,
  sideAlong,
  windowText,
} from '../../language/words.js';
import type { Words } from '../../language/words.js';
import { curveSentences } from './curves.js';
import { exact } from './exact.js';
import { family } from './family.js';
import { isOpenOutline } from '../../weiler-atherton/events.js';
import { regionSentences } from './regions.js';
import { purposes } from './page.js';
import { columnsOf, takes, zbufferSentences } from './zbuffer.js';

const rows = { one: 'row', other: 'rows' };
const vertices = { one: 'vertex', other: 'vertices' };

const colorOf = (event: Event<'fill'>, words: Words): string => {
  const { polygons, background } = words.ownersOf(event);
  if (polygons.length === 0) return background ? 'the background' : `the colour ${event.color}`;
  if (polygons.length === 1 && !background) return `the colour of ${polygons.join('')}`;
  return `the colour that ${listed([...polygons, ...(background ? ['the background'] : [])], 'and')} share`;
};

const place = (at: readonly (number | string)[], words: Words): string => {
  const corner = words.placeOf(at);
  return corner === null ? `point ${point(at)}` : `${corner} corner`;
};

const currentList = (words: Words): string =>
  words.ids((words.after.warnock?.apl?.entries ?? []).map(([id]) => id));

const { answer, causes, decided } = exact;

export const sentences: Sentences = {
  plane: ({ polygon, plane }) => `The plane of ${polygon}: a, b, c, d = ${list(plane)}.`,
  call: ({ of }) => `${of} begins: ${purposes[of]}`,
  depth: ({ at: line, polygon, point: at, z }, words) =>
    `At the ${place(at, words)} ${line === 'PC3' ? polygon : `the plane of ${polygon}`} has depth ${short(z)}.`,
  fault: ({ at, reason, x, y }) => {
    if (isOpenOutline(at)) {
      return 'An outline does not close here, by rounding: what cannot be closed is left out, and the run goes on.';
    }
    return x === undefined || y === undefined
      ? `The printed text fails here: ${reason}. The run ends.`
      : `The printed text fails here: ${reason}, pixel ${point([x, y])}.`;
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
    const { polygons, background } = words.ownersOf(event);
    const seen = polygons.join(' / ') || (background ? 'the background' : event.color);
    return `At ${point(event.point)} one sees ${seen}.`;
  },
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
  row: ({ at, row, left, right, first, end }, { after }) => {
    const met = at === 'PR1' ? 'the region' : (onlyOf(after) ?? 'the polygon');
    const where = first < end ? columnsOf(first, end - 1) : 'no pixel’s centre';
    return `Row ${short(row)} meets ${met} from ${short(left)} to ${short(right)}: ${where}.`;
  },
  draw: ({ polygon, runs }, words) =>
    `${takes(cells(runs), words)} the colour of ${polygon}, in ${words.counted(runs.length, rows)}.`,

  ...family.sentences,

  ...zbufferSentences,
  ...curveSentences,
  ...regionSentences,
};
