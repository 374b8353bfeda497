import { columnsOf } from '../i18n/ru/phrases.js';
import { regions } from '../i18n/ru/regions.js';
import { sentences as common } from '../i18n/ru/sentences.js';
import type { Sentences } from '../language/texts.js';
import { cells, point, short, shortApart } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { RegionEvents } from '../trace/events.js';
import { isOpenOutline } from './events.js';
import type { Region } from './events.js';
import { verticesOf } from './geometry.js';
import { boxOf, sized } from './sizes.js';

const pieces = { one: 'часть', few: 'части', other: 'частей' };
const ofPieces = { one: 'части', few: 'частей', other: 'частей' };

const sizeOf = (region: Region, words: Words): string =>
  sized(region, regions, (n, forms) => words.counted(n, forms));

const lies = {
  inside: 'внутри отсекающей области',
  outside: 'снаружи отсекающей области',
  same_side: 'на границе отсекающей области, обе по одну сторону: идёт внутрь',
  other_side: 'на границе отсекающей области, области по разные стороны: идёт наружу',
} as const;

const openOutline =
  'Из-за округления контур здесь не замыкается: незамкнутое отбрасывается, и алгоритм идёт дальше.';

export const sentences: Pick<Sentences, keyof RegionEvents | 'fault'> = {
  fault: (event, words) => (isOpenOutline(event.at) ? openOutline : common.fault(event, words)),
  row: ({ row, left, right, first, end }) => {
    const where = first < end ? columnsOf(first, end - 1) : 'ни одного центра пикселя';
    return `Строка ${short(row)} пересекает область от ${short(left)} до ${short(right)}: ${where}.`;
  },

  cut_to_area: ({ polygon, region }, words) =>
    region.length === 0
      ? `${polygon} весь лежит вне области рисования и не участвует.`
      : `${polygon} в области рисования: ${words.counted(verticesOf(region), regions.vertices)}.`,
  pierce: ({ polygon, other, normal, point: at }) =>
    `${polygon} и ${other} протыкают друг друга: прямая пересечения плоскостей, через ${point(at)}, делит их общую часть. В сторону ${point(normal)} ближе ${polygon}.`,
  split: ({ polygon }) =>
    `${polygon} разрезан по этой линии: каждая из двух частей лежит по одну сторону другого многоугольника.`,
  facets: ({ pieces: all }, words) =>
    `${words.counted(all.length, pieces)}: никакие две не протыкают друг друга.`,
  greatest_depth: ({ polygon, z }) =>
    `Наибольшая глубина этой части ${polygon} в её вершинах — ${short(z)}.`,
  sorted: ({ polygons }, words) =>
    polygons.length === 0
      ? 'Сортировать нечего.'
      : `По этой глубине, начиная с ближайшего: ${words.ids(polygons)}.`,
  push_list: ({ at, pieces: all }, words) => {
    const ids = words.ids(all.map(([id]) => id));
    const n = words.counted(all.length, pieces);
    if (at === 'WA3') return `Отсортированный список кладётся в стек: ${ids}.`;
    if (at === 'WA6') {
      return `То, что снаружи отсекающего многоугольника, рассматривается отдельно: в стеке ${n}, ${ids}.`;
    }
    const last = all.at(-1)?.[0] ?? '';
    return `Отсекающий многоугольник ${last} здесь не ближайший: в стек кладётся то, что ближе, и ${last} как фон: ${ids}.`;
  },
  pop_list: ({ clip, count }, words) =>
    `Из стека взят список из ${words.counted(count, ofPieces)}: первая из них, от ${clip}, — отсекающий многоугольник.`,
  beside: ({ polygon }, { after }) => {
    const { pieces: all = [], seen = 0 } = after.regions?.inHand ?? {};
    const [piece, clip] = [all[seen - 1], all[0]];
    if (piece === undefined || clip === undefined) return `${polygon} лежит снаружи.`;
    const box = boxOf(piece[1]);
    return `Габариты ${polygon}${box && `${box},`} лежат в стороне от габаритов ${clip[0]}${boxOf(clip[1])}: вся часть снаружи.`;
  },
  clipped: ({ at, polygon, clip, inside, outside }, words) => {
    if (inside.length === 0) return `Внутри ${clip} нет ничего от ${polygon}.`;
    if (at === 'SP1') return `Общая область ${polygon} и ${clip}: ${sizeOf(inside, words)}.`;
    if (outside.length === 0) return `Вся эта часть ${polygon} лежит внутри ${clip}.`;
    return `Граница ${clip} делит ${polygon} надвое: внутри ${sizeOf(inside, words)}, снаружи ${sizeOf(outside, words)}.`;
  },
  edge_piece: ({ from, to, lies: where }) =>
    `Граница от ${point(from)} до ${point(to)} — ${lies[where]}.`,
  entering: ({ point: at }) => `В точке ${point(at)} граница входит в отсекающую область.`,
  leaving: ({ point: at }) => `В точке ${point(at)} граница выходит из отсекающей области.`,
  behind: ({ polygon, clip, point: at, z, clipZ, order, behind }) => {
    const [own, other] = shortApart(z, clipZ);
    const where = `В точке ${point(at)}, среднем вершин, глубина ${polygon} равна ${own}, ${clip} — ${other}`;
    if (order === 0) {
      return behind
        ? `${where}: поровну, и ${clip} в сцене раньше, поэтому ${polygon} сзади.`
        : `${where}: поровну, и ${polygon} в сцене раньше, поэтому он ближе.`;
    }
    return behind
      ? `${where}: меньше, поэтому ${polygon} сзади, здесь и на всей части.`
      : `${where}: больше, поэтому ${polygon} ближе, здесь и на всей части.`;
  },
  nearer_ones: ({ polygons }, words) => {
    const clip = words.after.regions?.inHand?.pieces[0]?.[0] ?? 'отсекающего многоугольника';
    return polygons.length === 0
      ? `Внутри нет ничего ближе ${clip}: остальное внутри отбрасывается.`
      : `Ближе ${clip}: ${words.ids(polygons)}. Значит, первым виден не ${clip}.`;
  },
  show: ({ polygon, region }, words) =>
    `${polygon} виден в этой области (${sizeOf(region, words)}): внутри её границы нет ничего ближе.`,
  order: ({ polygon, other, point: at, z, otherZ, order }) => {
    const so = { '-1': 'дальше, чем', 0: 'так же близко, как', 1: 'ближе, чем' }[order];
    const sign = { '-1': '<', 0: '=', 1: '>' }[order];
    return `В центре ${point(at)} ${polygon} ${so} ${other}: ${shortApart(z, otherZ).join(` ${sign} `)}.`;
  },
  paint: ({ polygon, runs }, words) => {
    const n = cells(runs);
    if (n === 0) return `Цвет ${polygon} не получает ни один пиксель: центры заняты, или их нет.`;
    const taken = { one: 'пиксель', few: 'пикселя', other: 'пикселей' };
    return `Цвет ${polygon}: ${words.counted(n, taken)} с центром в этой области.`;
  },
  painted: () => 'Все видимые области закрашены.',
};
