import { columnsOf } from '../i18n/en/phrases.js';
import { regions } from '../i18n/en/regions.js';
import { sentences as common } from '../i18n/en/sentences.js';
import type { Sentences } from '../language/texts.js';
import { cells, point, short, shortApart } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { RegionEvents } from '../trace/events.js';
import { isOpenOutline } from './events.js';
import type { Region } from './events.js';
import { verticesOf } from './geometry.js';
import { boxOf, sized } from './sizes.js';

const pieces = { one: 'piece', other: 'pieces' };

const sizeOf = (region: Region, words: Words): string =>
  sized(region, regions, (n, forms) => words.counted(n, forms));

const lies = {
  inside: 'inside the clip region',
  outside: 'outside the clip region',
  same_side: 'on the outline of the clip region, both regions on one side: it goes inside',
  other_side: 'on the outline of the clip region, one region on each side: it goes outside',
} as const;

const openOutline =
  'An outline does not close here, by rounding: what cannot be closed is left out, and the run goes on.';

export const sentences: Pick<Sentences, keyof RegionEvents | 'fault'> = {
  fault: (event, words) => (isOpenOutline(event.at) ? openOutline : common.fault(event, words)),
  row: ({ row, left, right, first, end }) => {
    const where = first < end ? columnsOf(first, end - 1) : 'no pixel’s centre';
    return `Row ${short(row)} meets the region from ${short(left)} to ${short(right)}: ${where}.`;
  },

  cut_to_area: ({ polygon, region }, words) =>
    region.length === 0
      ? `No part of ${polygon} lies in the area: it is left out.`
      : `The part of ${polygon} in the area has ${words.counted(verticesOf(region), regions.vertices)}.`,
  pierce: ({ polygon, other, normal, point: at }) =>
    `${polygon} and ${other} pierce each other: the line where their planes meet, through ${point(at)}, divides what they share. Towards ${point(normal)} ${polygon} is nearer.`,
  split: ({ polygon }) =>
    `${polygon} is split along that line: each of its two pieces is on one side of the other polygon.`,
  facets: ({ pieces: all }, words) =>
    `${words.counted(all.length, pieces)}: no two of them pierce each other.`,
  greatest_depth: ({ polygon, z }) =>
    `The greatest depth of this piece of ${polygon} at its vertices is ${short(z)}.`,
  sorted: ({ polygons }, words) =>
    polygons.length === 0
      ? 'There is nothing to sort.'
      : `The nearest first, by that depth: ${words.ids(polygons)}.`,
  push_list: ({ at, pieces: all }, words) => {
    const ids = words.ids(all.map(([id]) => id));
    const n = words.counted(all.length, pieces);
    if (at === 'WA3') return `The sorted list goes on the stack: ${ids}.`;
    if (at === 'WA6') {
      return `What lies outside the clip polygon is handled separately: ${n} on the stack, ${ids}.`;
    }
    const last = all.at(-1)?.[0] ?? '';
    return `The clip polygon ${last} is not the nearest here: what is nearer goes on the stack, and ${last} as its ground, ${ids}.`;
  },
  pop_list: ({ clip, count }, words) =>
    `The list of ${words.counted(count, pieces)} comes off the stack: its first, a piece of ${clip}, is the clip polygon.`,
  beside: ({ polygon }, { after }) => {
    const { pieces: all = [], seen = 0 } = after.regions?.inHand ?? {};
    const [piece, clip] = [all[seen - 1], all[0]];
    if (piece === undefined || clip === undefined) return `${polygon} lies outside.`;
    const box = boxOf(piece[1]);
    return `The box of ${polygon}${box && `${box},`} lies beside that of ${clip[0]}${boxOf(clip[1])}: all of the piece is outside.`;
  },
  clipped: ({ at, polygon, clip, inside, outside }, words) => {
    if (inside.length === 0) return `No part of ${polygon} lies inside ${clip}.`;
    if (at === 'SP1') {
      return `${polygon} and ${clip} have a region of ${sizeOf(inside, words)} in common.`;
    }
    if (outside.length === 0) return `All of this piece of ${polygon} lies inside ${clip}.`;
    return `The outline of ${clip} cuts ${polygon} in two: inside ${sizeOf(inside, words)}, outside ${sizeOf(outside, words)}.`;
  },
  edge_piece: ({ from, to, lies: where }) =>
    `The outline from ${point(from)} to ${point(to)} lies ${lies[where]}.`,
  entering: ({ point: at }) => `At ${point(at)} the outline enters the clip region.`,
  leaving: ({ point: at }) => `At ${point(at)} the outline leaves the clip region.`,
  behind: ({ polygon, clip, point: at, z, clipZ, order, behind }) => {
    const [own, other] = shortApart(z, clipZ);
    const where = `At ${point(at)}, the mean of its vertices, ${polygon} has depth ${own}, ${clip} ${other}`;
    if (order === 0) {
      return behind
        ? `${where}: equal, and ${clip} comes first in the scene, so ${polygon} is behind.`
        : `${where}: equal, and ${polygon} comes first in the scene, so it is nearer.`;
    }
    return behind
      ? `${where}: less, so ${polygon} is behind, here as all over the piece.`
      : `${where}: greater, so ${polygon} is nearer, here as all over the piece.`;
  },
  nearer_ones: ({ polygons }, words) => {
    const clip = words.after.regions?.inHand?.pieces[0]?.[0] ?? 'the clip polygon';
    return polygons.length === 0
      ? `Nothing inside is nearer than ${clip}: the rest inside is dropped.`
      : `Nearer than ${clip}: ${words.ids(polygons)}. So ${clip} is not what shows first.`;
  },
  show: ({ polygon, region }, words) =>
    `${polygon} is visible in this region of ${sizeOf(region, words)}: nothing inside its outline is nearer.`,
  order: ({ polygon, other, point: at, z, otherZ, order }) => {
    const so = { '-1': 'behind', 0: 'as near as', 1: 'nearer than' }[order];
    const sign = { '-1': '<', 0: '=', 1: '>' }[order];
    return `At the centre ${point(at)} ${polygon} is ${so} ${other}: ${shortApart(z, otherZ).join(` ${sign} `)}.`;
  },
  paint: ({ polygon, runs }, words) => {
    const n = cells(runs);
    return n === 0
      ? `No pixel takes the colour of ${polygon}: the centres in this region are taken, or there are none.`
      : `${words.counted(n, { one: 'pixel', other: 'pixels' })} with ${n === 1 ? 'its centre' : 'their centres'} in this region ${n === 1 ? 'takes' : 'take'} the colour of ${polygon}.`;
  },
  painted: () => 'All visible regions are painted.',
};
