import type { SentencesOf } from '../language/texts.js';
import { agrees, capital, cells, listed, orderOf, rangeOf } from '../language/words.js';
import type { Words } from '../language/words.js';
import { hasDefect } from '../trace/editions.js';
import type { ZBufferEvents } from '../trace/events.js';

/** "Edge 1 leaves", "Edges 1 and 0 leave". */
const edgesDo = {
  en: (list: readonly number[], one: string, several: string): string =>
    `${list.length === 1 ? 'Edge' : 'Edges'} ${listed(list, 'and')} ${list.length === 1 ? one : several}`,
  ru: (list: readonly number[], one: string, several: string): string =>
    `${list.length === 1 ? 'Ребро' : 'Рёбра'} ${listed(list, 'и')} ${list.length === 1 ? one : several}`,
};

const when = (next: number | string, before: string, words: Words): string =>
  next === 'inf' ? '' : `; ${before} ${words.short(next)}`;

export const sentences: SentencesOf<keyof ZBufferEvents> = {
  clear: {
    en: ({ z }, { short }) =>
      `The picture is all background; every cell of the Z-buffer holds ${short(z)}.`,
    ru: ({ z }, { short }) =>
      `Изображение заполнено фоном, каждая ячейка Z-буфера — значением ${short(z)}.`,
  },
  polygon: {
    en: ({ polygon }) => `Next polygon: ${polygon}. S and the AEL are empty.`,
    ru: ({ polygon }) => `Следующий многоугольник: ${polygon}. S и AEL пусты.`,
  },
  edge: {
    en: ({ edge, rows }, { short }) => {
      const [first, last] = rows ?? [];
      if (first === undefined || last === undefined) return `Edge ${edge} joins S.`;
      if (last < first) return `Edge ${edge} joins S; it crosses the centre of no row.`;
      const which =
        first === last ? `row ${short(first)}` : `rows ${short(first)} to ${short(last)}`;
      return `Edge ${edge} joins S: ${which}.`;
    },
    ru: ({ edge, rows }) => {
      const [first, last] = rows ?? [];
      if (first === undefined || last === undefined) return `Ребро ${edge} входит в S.`;
      if (last < first)
        return `Ребро ${edge} входит в S; оно не пересекает центра ни одной строки.`;
      return `Ребро ${edge} входит в S: ${first === last ? 'строка' : 'строки'} ${rangeOf(first, last)}.`;
    },
  },
  extent: {
    en: ({ ymin, ymax }, { short }) =>
      `The polygon reaches from y = ${short(ymin)} to ${short(ymax)}.`,
    ru: ({ ymin, ymax }, { short }) =>
      `Многоугольник простирается от y = ${short(ymin)} до ${short(ymax)}.`,
  },
  scanline: {
    en: ({ y, row }, { short }) => `The scanline is row ${short(row)}, y = ${short(y)}.`,
    ru: ({ y, row }, { short }) => `Строка развёртки ${short(row)}, y = ${short(y)}.`,
  },
  ael_add: {
    en: ({ edge, x, z, until }, { short }) =>
      `Edge ${edge} begins: it joins the AEL at x = ${short(x)}, z = ${short(z)}, until ${short(until)}.`,
    ru: ({ edge, x, z, until }, { short }) =>
      `Ребро ${edge} начинается: входит в AEL с x = ${short(x)}, z = ${short(z)}, до отметки ${short(until)}.`,
  },
  horizontal: {
    en: ({ edge }) => `Edge ${edge} is horizontal: it is drawn at once and does not join the AEL.`,
    ru: ({ edge }) => `Ребро ${edge} горизонтально: оно рисуется сразу и в AEL не входит.`,
  },
  leave: {
    en: ({ edges, next }, words) =>
      edges.length === 0
        ? 'No edge leaves S.'
        : `${edgesDo.en(edges, 'leaves', 'leave')} S${when(next, 'the next begins at', words)}.`,
    ru: ({ edges, next }, words) =>
      edges.length === 0
        ? 'Из S ничего не удаляется.'
        : `${edgesDo.ru(edges, 'удаляется', 'удаляются')} из S${when(next, 'следующее начинается на отметке', words)}.`,
  },
  ael_sort: {
    en: ({ edges, next }, words) =>
      edges.length === 0
        ? 'The AEL is empty.'
        : `The AEL from left to right: ${words.list(edges)}${when(next, 'the next change is at', words)}.`,
    ru: ({ edges, next }, words) =>
      edges.length === 0
        ? 'AEL пуст.'
        : `AEL слева направо: ${words.list(edges)}${when(next, 'следующее изменение — на отметке', words)}.`,
  },
  line: {
    en: ({ row, from, to }, { short }) =>
      `Row ${short(row)} from x = ${short(from[0])} (z = ${short(from[1])}) to x = ${short(to[0])} (z = ${short(to[1])}).`,
    ru: ({ row, from, to }, { short }) =>
      `Строка ${short(row)} от x = ${short(from[0])} (z = ${short(from[1])}) до x = ${short(to[0])} (z = ${short(to[1])}).`,
  },
  miss: {
    en: ({ at }) =>
      at === 'L1'
        ? 'The row lies outside the area: nothing to show.'
        : 'No pixel of the area lies between the ends: nothing to show.',
    ru: ({ at }) =>
      at === 'L1'
        ? 'Строка лежит вне области: показывать нечего.'
        : 'Между концами нет ни одного пикселя области: показывать нечего.',
  },
  slope: {
    en: ({ dz }, { short }) =>
      dz === 'nan'
        ? 'The change of z from pixel to pixel is not a number.'
        : `From pixel to pixel z changes by ${short(dz)}.`,
    ru: ({ dz }, { short }) =>
      dz === 'nan'
        ? 'Изменение z от пикселя к пикселю — не число.'
        : `От пикселя к пикселю z меняется на ${short(dz)}.`,
  },
  columns: {
    en: ({ first, end, z }, { columnsOf, short }) =>
      first < end
        ? `${capital(columnsOf(first, end - 1))}: z = ${short(z)} at the first.`
        : 'No pixel centre lies between the ends.',
    ru: ({ first, end, z }, { columnsOf, short }) =>
      first < end
        ? `${capital(columnsOf(first, end - 1))}: z = ${short(z)} в первом.`
        : 'Между концами нет ни одного центра пикселя.',
  },
  pixel: {
    en: ({ x, y, z, stored, shown }, { header, shortApart, point }) => {
      const [depth, before] = shortApart(z, stored);
      const order = orderOf(z, stored);
      if (hasDefect(header.edition, 'x-z7') && shown !== (order === 1)) {
        return shown
          ? `Pixel ${point([x, y])}: ${depth} is as near as ${before}, so it shows.`
          : `Pixel ${point([x, y])}: ${depth} is nearer than ${before} but greater than 1, so it stays hidden.`;
      }
      const is = agrees(shown, z, stored) ? 'is' : 'counts as';
      return shown
        ? `Pixel ${point([x, y])}: ${depth} ${is} nearer than ${before}, so it shows.`
        : `Pixel ${point([x, y])}: ${depth} ${is} not nearer than ${before}, so it stays hidden.`;
    },
    ru: ({ x, y, z, stored, shown }, { header, shortApart, point }) => {
      const [depth, before] = shortApart(z, stored);
      const order = orderOf(z, stored);
      if (hasDefect(header.edition, 'x-z7') && shown !== (order === 1)) {
        return shown
          ? `Пиксель ${point([x, y])}: ${depth} так же близко, как ${before}, и многоугольник виден.`
          : `Пиксель ${point([x, y])}: ${depth} ближе, чем ${before}, но больше 1, и многоугольник закрыт.`;
      }
      const own = agrees(shown, z, stored) ? depth : `${depth} считается`;
      return shown
        ? `Пиксель ${point([x, y])}: ${own} ближе, чем ${before}, и многоугольник виден.`
        : `Пиксель ${point([x, y])}: ${own} не ближе, чем ${before}, и многоугольник закрыт.`;
    },
  },
  span: {
    en: ({ row, runs }, words) =>
      cells(runs) === 0
        ? `No pixel of row ${words.short(row)} changes.`
        : `${words.takes(cells(runs))} the colour of ${words.after.zbuffer?.polygon ?? ''} in row ${words.short(row)}.`,
    ru: ({ row, runs }, words) =>
      cells(runs) === 0
        ? `В строке ${words.short(row)} ничего не меняется.`
        : `${words.takes(cells(runs))} цвет ${words.after.zbuffer?.polygon ?? ''} в строке ${words.short(row)}.`,
  },
  ael_drop: {
    en: ({ edges, next }, words) =>
      edges.length === 0
        ? 'No edge ends here.'
        : `${edgesDo.en(edges, 'ends here and leaves', 'end here and leave')} the AEL${when(next, 'the next change is at', words)}.`,
    ru: ({ edges, next }, words) =>
      edges.length === 0
        ? 'Ни одно ребро здесь не заканчивается.'
        : `${edgesDo.ru(edges, 'заканчивается и удаляется', 'заканчиваются и удаляются')} из AEL${when(next, 'следующее изменение — на отметке', words)}.`,
  },
  ael_step: {
    en: ({ edge, x, z }, { short }) => `Edge ${edge} steps to x = ${short(x)}, z = ${short(z)}.`,
    ru: ({ edge, x, z }, { short }) =>
      `Ребро ${edge} делает шаг: x = ${short(x)}, z = ${short(z)}.`,
  },
};
