import { point, short, shortApart } from '../i18n/ru/numbers.js';
import { columnsOf, takes } from '../i18n/ru/phrases.js';
import type { Sentences } from '../language/texts.js';
import { capital, cells, listed, orderOf, rangeOf } from '../language/words.js';
import { hasDefect } from '../trace/editions.js';
import type { ZBufferEvents } from '../trace/events.js';

/** «Ребро 1 удаляется», «Рёбра 1 и 0 удаляются». */
const edgesDo = (list: readonly number[], one: string, several: string): string =>
  `${list.length === 1 ? 'Ребро' : 'Рёбра'} ${listed(list, 'и')} ${list.length === 1 ? one : several}`;

const when = (next: number | string, before: string): string =>
  next === 'inf' ? '' : `; ${before} ${short(next)}`;

export const sentences: Pick<Sentences, keyof ZBufferEvents> = {
  clear: ({ z }) => `Изображение заполнено фоном, каждая ячейка Z-буфера — значением ${short(z)}.`,
  polygon: ({ polygon }) => `Следующий многоугольник: ${polygon}. S и AEL пусты.`,
  edge: ({ edge, rows }) => {
    const [first, last] = rows ?? [];
    if (first === undefined || last === undefined) return `Ребро ${edge} входит в S.`;
    if (last < first) return `Ребро ${edge} входит в S; оно не пересекает центра ни одной строки.`;
    return `Ребро ${edge} входит в S: ${first === last ? 'строка' : 'строки'} ${rangeOf(first, last)}.`;
  },
  extent: ({ ymin, ymax }) => `Многоугольник простирается от y = ${short(ymin)} до ${short(ymax)}.`,
  scanline: ({ y, row }) => `Строка растра ${short(row)}, y = ${short(y)}.`,
  ael_add: ({ edge, x, z, until }) =>
    `Ребро ${edge} начинается: входит в AEL с x = ${short(x)}, z = ${short(z)}, до отметки ${short(until)}.`,
  horizontal: ({ edge }) => `Ребро ${edge} горизонтально: оно рисуется сразу и в AEL не входит.`,
  leave: ({ edges, next }) =>
    edges.length === 0
      ? 'Из S ничего не удаляется.'
      : `${edgesDo(edges, 'удаляется', 'удаляются')} из S${when(next, 'следующее начинается на отметке')}.`,
  ael_sort: ({ edges, next }, words) =>
    edges.length === 0
      ? 'AEL пуст.'
      : `AEL слева направо: ${words.list(edges)}${when(next, 'следующее изменение — на отметке')}.`,
  line: ({ row, from, to }) =>
    `Строка ${short(row)} от x = ${short(from[0])} (z = ${short(from[1])}) до x = ${short(to[0])} (z = ${short(to[1])}).`,
  miss: ({ at }) =>
    at === 'L1'
      ? 'Строка лежит вне области: показывать нечего.'
      : 'Между концами нет ни одного пикселя области: показывать нечего.',
  slope: ({ dz }) => `От пикселя к пикселю z меняется на ${short(dz)}.`,
  columns: ({ first, end, z }) =>
    first < end
      ? `${capital(columnsOf(first, end - 1))}: z = ${short(z)} в первом.`
      : 'Между концами нет ни одного центра пикселя.',
  pixel: ({ x, y, z, stored, shown }, { header }) => {
    const [depth, before] = shortApart(z, stored);
    const order = orderOf(z, stored);
    if (hasDefect(header.edition, 'x-z7') && shown !== (order === 1)) {
      return shown
        ? `Пиксель ${point([x, y])}: ${depth} так же близко, как ${before}, — он виден.`
        : `Пиксель ${point([x, y])}: ${depth} ближе, чем ${before}, но больше 1, — он закрыт.`;
    }
    return shown
      ? `Пиксель ${point([x, y])}: ${depth} ближе, чем ${before}, — он виден.`
      : `Пиксель ${point([x, y])}: ${depth} не ближе, чем ${before}, — он закрыт.`;
  },
  span: ({ row, runs }, words) =>
    cells(runs) === 0
      ? `В строке ${short(row)} ничего не меняется.`
      : `${takes(cells(runs), words)} цвет ${words.after.zbuffer?.polygon ?? ''} в строке ${short(row)}.`,
  ael_drop: ({ edges, next }) =>
    edges.length === 0
      ? 'Ни одно ребро здесь не заканчивается.'
      : `${edgesDo(edges, 'заканчивается и удаляется', 'заканчиваются и удаляются')} из AEL${when(next, 'следующее изменение — на отметке')}.`,
  ael_step: ({ edge, x, z }) => `Ребро ${edge} делает шаг: x = ${short(x)}, z = ${short(z)}.`,
};
