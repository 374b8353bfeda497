import { columnsOf, takes } from '../i18n/en/phrases.js';
import type { Sentences } from '../language/texts.js';
import { capital, cells, listed, orderOf, point, short, shortApart } from '../language/words.js';
import { hasDefect } from '../trace/editions.js';
import type { ZBufferEvents } from '../trace/events.js';

/** "Edge 1 leaves", "Edges 1 and 0 leave". */
const edgesDo = (list: readonly number[], one: string, several: string): string =>
  `${list.length === 1 ? 'Edge' : 'Edges'} ${listed(list, 'and')} ${list.length === 1 ? one : several}`;

const when = (next: number | string, before: string): string =>
  next === 'inf' ? '' : `; ${before} ${short(next)}`;

export const sentences: Pick<Sentences, keyof ZBufferEvents> = {
  clear: ({ z }) => `The picture is all background; every cell of the Z-buffer holds ${short(z)}.`,
  polygon: ({ polygon }) => `Next polygon: ${polygon}. S and the AEL are empty.`,
  edge: ({ edge, rows }) => {
    const [first, last] = rows ?? [];
    if (first === undefined || last === undefined) return `Edge ${edge} joins S.`;
    if (last < first) return `Edge ${edge} joins S; it crosses the centre of no row.`;
    const which = first === last ? `row ${short(first)}` : `rows ${short(first)} to ${short(last)}`;
    return `Edge ${edge} joins S: ${which}.`;
  },
  extent: ({ ymin, ymax }) => `The polygon reaches from y = ${short(ymin)} to ${short(ymax)}.`,
  scanline: ({ y, row }) => `The scanline is row ${short(row)}, y = ${short(y)}.`,
  ael_add: ({ edge, x, z, until }) =>
    `Edge ${edge} begins: it joins the AEL at x = ${short(x)}, z = ${short(z)}, until ${short(until)}.`,
  horizontal: ({ edge }) =>
    `Edge ${edge} is horizontal: it is drawn at once and does not join the AEL.`,
  leave: ({ edges, next }) =>
    edges.length === 0
      ? 'No edge leaves S.'
      : `${edgesDo(edges, 'leaves', 'leave')} S${when(next, 'the next begins at')}.`,
  ael_sort: ({ edges, next }, words) =>
    edges.length === 0
      ? 'The AEL is empty.'
      : `The AEL from left to right: ${words.list(edges)}${when(next, 'the next change is at')}.`,
  line: ({ row, from, to }) =>
    `Row ${short(row)} from x = ${short(from[0])} (z = ${short(from[1])}) to x = ${short(to[0])} (z = ${short(to[1])}).`,
  miss: ({ at }) =>
    at === 'L1'
      ? 'The row lies outside the area: nothing to show.'
      : 'No pixel of the area lies between the ends: nothing to show.',
  slope: ({ dz }) => `From pixel to pixel z changes by ${short(dz)}.`,
  columns: ({ first, end, z }) =>
    first < end
      ? `${capital(columnsOf(first, end - 1))}: z = ${short(z)} at the first.`
      : 'No pixel centre lies between the ends.',
  pixel: ({ x, y, z, stored, shown }, { header }) => {
    const [depth, before] = shortApart(z, stored);
    const order = orderOf(z, stored);
    if (hasDefect(header.edition, 'x-z7') && shown !== (order === 1)) {
      return shown
        ? `Pixel ${point([x, y])}: ${depth} is as near as ${before}, so it shows.`
        : `Pixel ${point([x, y])}: ${depth} is nearer than ${before} but greater than 1, so it stays hidden.`;
    }
    return shown
      ? `Pixel ${point([x, y])}: ${depth} is nearer than ${before}, so it shows.`
      : `Pixel ${point([x, y])}: ${depth} is not nearer than ${before}, so it stays hidden.`;
  },
  span: ({ row, runs }, words) =>
    cells(runs) === 0
      ? `No pixel of row ${short(row)} changes.`
      : `${takes(cells(runs), words)} the colour of ${words.after.zbuffer?.polygon ?? ''}, in row ${short(row)}.`,
  ael_drop: ({ edges, next }) =>
    edges.length === 0
      ? 'No edge ends here.'
      : `${edgesDo(edges, 'ends here and leaves', 'end here and leave')} the AEL${when(next, 'the next change is at')}.`,
  ael_step: ({ edge, x, z }) => `Edge ${edge} steps to x = ${short(x)}, z = ${short(z)}.`,
};
