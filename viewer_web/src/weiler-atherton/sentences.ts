import { commonSentences } from '../algorithm/common-sentences.js';
import type { SentencesOf } from '../language/texts.js';
import { cells, orderOf, relationBy } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { WeilerAthertonEvents } from '../trace/events.js';
import type { Region } from '../trace/values.js';
import { isOpenOutline } from './state.js';
import { boxOf, sized, verticesOf } from './geometry.js';

const pieces = {
  en: { one: 'piece', other: 'pieces' },
  ru: { one: 'часть', few: 'части', other: 'частей' },
};

const sizeOf = (region: Region, words: Words): string =>
  sized(region, words.texts.regions, (n, forms) => words.counted(n, forms));

const lies = {
  en: {
    inside: 'inside the clip region',
    outside: 'outside the clip region',
    same_side:
      'on the outline of the clip region, with both regions on the same side: it counts as inside',
    other_side:
      'on the outline of the clip region, with one region on each side: it counts as outside',
  },
  ru: {
    inside: 'внутри отсекающей области',
    outside: 'снаружи отсекающей области',
    same_side:
      'на контуре отсекающей области, обе области по одну сторону от него: считается внутренним',
    other_side:
      'на контуре отсекающей области, области по разные стороны от него: считается внешним',
  },
};

const openOutline = {
  en: 'Rounding leaves an outline open here. The run drops it and continues.',
  ru: 'Из-за округления контур здесь не замыкается. Он отбрасывается, и прогон идёт дальше.',
};

const ofPieces = { one: 'части', few: 'частей', other: 'частей' };

export const sentences: SentencesOf<keyof WeilerAthertonEvents | 'fault'> = {
  fault: {
    en: (event, words) =>
      isOpenOutline(event.at) ? openOutline.en : commonSentences.fault.en(event, words),
    ru: (event, words) =>
      isOpenOutline(event.at) ? openOutline.ru : commonSentences.fault.ru(event, words),
  },
  row: {
    en: ({ row, left, right, first, end }, { columnsOf, short }) => {
      const where = first < end ? columnsOf(first, end - 1) : 'no pixel’s centre';
      return `Row ${short(row)} meets the region from ${short(left)} to ${short(right)}: ${where}.`;
    },
    ru: ({ row, left, right, first, end }, { columnsOf, short }) => {
      const where = first < end ? columnsOf(first, end - 1) : 'ни одного центра пикселя';
      return `Строка ${short(row)} пересекает область от ${short(left)} до ${short(right)}: ${where}.`;
    },
  },

  cut_to_area: {
    en: ({ polygon, region }, words) =>
      region.length === 0
        ? `No part of ${polygon} lies in the area: it is left out.`
        : `The part of ${polygon} in the area has ${words.counted(verticesOf(region), words.texts.regions.vertices)}.`,
    ru: ({ polygon, region }, words) =>
      region.length === 0
        ? `${polygon} весь лежит вне области рисования и не участвует.`
        : `${polygon} в области рисования: ${words.counted(verticesOf(region), words.texts.regions.vertices)}.`,
  },
  pierce: {
    en: ({ polygon, other, normal, point: at }, { point }) =>
      `${polygon} and ${other} pierce each other: the line where their planes meet, through ${point(at)}, divides what they share. In the direction ${point(normal)}, ${polygon} is nearer.`,
    ru: ({ polygon, other, normal, point: at }, { point }) =>
      `${polygon} и ${other} протыкают друг друга: прямая пересечения их плоскостей, проходящая через ${point(at)}, делит их общую часть. По направлению ${point(normal)} от неё ближе ${polygon}.`,
  },
  split: {
    en: ({ polygon }) =>
      `${polygon} is split along that line: each of its two pieces is on one side of the other polygon.`,
    ru: ({ polygon }) =>
      `${polygon} разрезан по этой линии: каждая из двух частей лежит по одну сторону другого многоугольника.`,
  },
  facets: {
    en: ({ pieces: all }, words) =>
      `${words.counted(all.length, pieces.en)}: no two of them pierce each other.`,
    ru: ({ pieces: all }, words) =>
      `${words.counted(all.length, pieces.ru)}: никакие две не протыкают друг друга.`,
  },
  greatest_depth: {
    en: ({ polygon, z }, { short }) =>
      `The greatest depth of this piece of ${polygon} at its vertices is ${short(z)}.`,
    ru: ({ polygon, z }, { short }) =>
      `Наибольшая глубина этой части ${polygon} в её вершинах — ${short(z)}.`,
  },
  sorted: {
    en: ({ polygons }, words) =>
      polygons.length === 0
        ? 'There is nothing to sort.'
        : `The nearest first, by that depth: ${words.ids(polygons)}.`,
    ru: ({ polygons }, words) =>
      polygons.length === 0
        ? 'Сортировать нечего.'
        : `По этой глубине, начиная с ближайшего: ${words.ids(polygons)}.`,
  },
  push_list: {
    en: ({ at, pieces: all }, words) => {
      const ids = words.ids(all.map(([id]) => id));
      const n = words.counted(all.length, pieces.en);
      if (at === 'WA3') return `The sorted list goes on the stack: ${ids}.`;
      if (at === 'WA6') {
        return `What lies outside the clip polygon is handled separately: a list of ${n} (${ids}) goes on the stack.`;
      }
      const last = all.at(-1)?.[0] ?? '';
      return `The clip polygon ${last} is not the nearest here. What is nearer goes on the stack, and ${last} comes last, as its ground: ${ids}.`;
    },
    ru: ({ at, pieces: all }, words) => {
      const ids = words.ids(all.map(([id]) => id));
      const n = words.counted(all.length, ofPieces);
      if (at === 'WA3') return `Отсортированный список кладётся в стек: ${ids}.`;
      if (at === 'WA6') {
        return `То, что снаружи отсекающего многоугольника, рассматривается отдельно: в стек кладётся список из ${n} (${ids}).`;
      }
      const last = all.at(-1)?.[0] ?? '';
      return `Отсекающий многоугольник ${last} здесь не ближайший. В стек кладётся то, что ближе, и последним, как фон, сам ${last}: ${ids}.`;
    },
  },
  pop_list: {
    en: ({ clip, count }, words) =>
      `The list of ${words.counted(count, pieces.en)} comes off the stack: its first, a piece of ${clip}, is the clip polygon.`,
    ru: ({ clip, count }, words) =>
      `Из стека взят список из ${words.counted(count, ofPieces)}: первая, от ${clip}, — отсекающий многоугольник.`,
  },
  beside: {
    en: ({ polygon }, words) => {
      const { pieces: all = [], seen = 0 } = words.after.weilerAtherton?.inHand ?? {};
      const [piece, clip] = [all[seen - 1], all[0]];
      if (piece === undefined || clip === undefined) return `${polygon} lies outside.`;
      const box = boxOf(piece[1], words);
      return `The box of ${polygon}${box && `${box},`} lies beside that of ${clip[0]}${boxOf(clip[1], words)}: all of the piece is outside.`;
    },
    ru: ({ polygon }, words) => {
      const { pieces: all = [], seen = 0 } = words.after.weilerAtherton?.inHand ?? {};
      const [piece, clip] = [all[seen - 1], all[0]];
      if (piece === undefined || clip === undefined) return `${polygon} лежит снаружи.`;
      const box = boxOf(piece[1], words);
      return `Габаритный прямоугольник ${polygon}${box && `${box},`} не пересекается с прямоугольником ${clip[0]}${boxOf(clip[1], words)}: вся часть снаружи.`;
    },
  },
  clipped: {
    en: ({ at, polygon, clip, inside, outside }, words) => {
      if (inside.length === 0) return `No part of ${polygon} lies inside ${clip}.`;
      if (at === 'SP1') {
        return `${polygon} and ${clip} have a region of ${sizeOf(inside, words)} in common.`;
      }
      if (outside.length === 0) return `All of this piece of ${polygon} lies inside ${clip}.`;
      return `The outline of ${clip} cuts ${polygon} in two: ${sizeOf(inside, words)} inside; ${sizeOf(outside, words)} outside.`;
    },
    ru: ({ at, polygon, clip, inside, outside }, words) => {
      if (inside.length === 0) return `Внутри ${clip} нет ничего от ${polygon}.`;
      if (at === 'SP1') return `Общая область ${polygon} и ${clip}: ${sizeOf(inside, words)}.`;
      if (outside.length === 0) return `Вся эта часть ${polygon} лежит внутри ${clip}.`;
      return `Контур ${clip} делит ${polygon} надвое: внутри ${sizeOf(inside, words)}; снаружи ${sizeOf(outside, words)}.`;
    },
  },
  edge_piece: {
    en: ({ from, to, lies: where }, { point }) =>
      `The outline from ${point(from)} to ${point(to)} lies ${lies.en[where]}.`,
    ru: ({ from, to, lies: where }, { point }) =>
      `Контур от ${point(from)} до ${point(to)} — ${lies.ru[where]}.`,
  },
  entering: {
    en: ({ point: at }, { point }) => `At ${point(at)} the outline enters the clip region.`,
    ru: ({ point: at }, { point }) => `В точке ${point(at)} контур входит в отсекающую область.`,
  },
  leaving: {
    en: ({ point: at }, { point }) => `At ${point(at)} the outline leaves the clip region.`,
    ru: ({ point: at }, { point }) => `В точке ${point(at)} контур выходит из отсекающей области.`,
  },
  behind: {
    en: ({ polygon, clip, point: at, z, clipZ, order, behind }, { shortApart, point }) => {
      const [own, other] = shortApart(z, clipZ);
      const where = `At ${point(at)}, the mean of its vertices, ${polygon} has depth ${own} and ${clip} has ${other}`;
      const is = orderOf(z, clipZ) === order ? '' : 'which counts as ';
      if (order === 0) {
        return behind
          ? `${where}: ${is}equal, and ${clip} comes first in the scene, so ${polygon} is behind.`
          : `${where}: ${is}equal, and ${polygon} comes first in the scene, so it is nearer.`;
      }
      return behind
        ? `${where}: ${is}less, so ${polygon} is behind, here and on the whole piece.`
        : `${where}: ${is}greater, so ${polygon} is nearer, here and on the whole piece.`;
    },
    ru: ({ polygon, clip, point: at, z, clipZ, order, behind }, { shortApart, point }) => {
      const [own, other] = shortApart(z, clipZ);
      const where = `В средней точке вершин ${point(at)} глубина ${polygon} равна ${own}, ${clip} — ${other}`;
      const is = orderOf(z, clipZ) === order ? '' : 'считается, что ';
      if (order === 0) {
        return behind
          ? `${where}: ${is}глубины равны, и ${clip} в сцене раньше, поэтому ${polygon} сзади.`
          : `${where}: ${is}глубины равны, и ${polygon} в сцене раньше, поэтому он ближе.`;
      }
      return behind
        ? `${where}: ${is}меньше, поэтому ${polygon} сзади, здесь и на всей части.`
        : `${where}: ${is}больше, поэтому ${polygon} ближе, здесь и на всей части.`;
    },
  },
  nearer_ones: {
    en: ({ polygons }, words) => {
      const clip = words.after.weilerAtherton?.inHand?.pieces[0]?.[0] ?? 'the clip polygon';
      return polygons.length === 0
        ? `Nothing inside is nearer than ${clip}: the rest inside is dropped.`
        : `Nearer than ${clip}: ${words.ids(polygons)}. So ${clip} is not the nearest here.`;
    },
    ru: ({ polygons }, words) => {
      const clip =
        words.after.weilerAtherton?.inHand?.pieces[0]?.[0] ?? 'отсекающего многоугольника';
      return polygons.length === 0
        ? `Внутри нет ничего ближе ${clip}: остальное внутри отбрасывается.`
        : `Ближе ${clip}: ${words.ids(polygons)}. Значит, ${clip} здесь не ближе всех.`;
    },
  },
  show: {
    en: ({ polygon, region }, words) =>
      `${polygon} is visible in this region of ${sizeOf(region, words)}: nothing inside its outline is nearer.`,
    ru: ({ polygon, region }, words) =>
      `${polygon} виден в этой области (${sizeOf(region, words)}): внутри её контура нет ничего ближе.`,
  },
  order: {
    en: ({ polygon, other, point: at, z, otherZ, order }, { point, shortApart }) => {
      const so = { '-1': 'behind', 0: 'as near as', 1: 'nearer than' }[order];
      const [own, others] = shortApart(z, otherZ);
      return orderOf(z, otherZ) === order
        ? `At the centre ${point(at)} ${polygon} is ${so} ${other}: ${own} ${relationBy[order]} ${others}.`
        : `At the centre ${point(at)} ${polygon} counts as ${so} ${other}: ${own} against ${others}.`;
    },
    ru: ({ polygon, other, point: at, z, otherZ, order }, { point, shortApart }) => {
      const so = { '-1': 'дальше, чем', 0: 'так же близко, как', 1: 'ближе, чем' }[order];
      const [own, others] = shortApart(z, otherZ);
      return orderOf(z, otherZ) === order
        ? `В центре ${point(at)} ${polygon} ${so} ${other}: ${own} ${relationBy[order]} ${others}.`
        : `В центре ${point(at)} ${polygon} считается ${so} ${other}: ${own} против ${others}.`;
    },
  },
  paint: {
    en: ({ polygon, runs }, words) => {
      const n = cells(runs);
      return n === 0
        ? `No pixel takes the colour of ${polygon}: the centres in this region are taken, or there are none.`
        : `${words.counted(n, { one: 'pixel', other: 'pixels' })} with ${n === 1 ? 'its centre' : 'their centres'} in this region ${n === 1 ? 'takes' : 'take'} the colour of ${polygon}.`;
    },
    ru: ({ polygon, runs }, words) => {
      const n = cells(runs);
      if (n === 0) return `Цвет ${polygon} не получает ни один пиксель: центры заняты, или их нет.`;
      const taken = { one: 'пиксель', few: 'пикселя', other: 'пикселей' };
      return `Цвет ${polygon}: ${words.counted(n, taken)} с центром в этой области.`;
    },
  },
  painted: {
    en: () => 'All visible regions are painted.',
    ru: () => 'Все видимые области закрашены.',
  },
};
