import type { Bilingual } from '../language/language.js';
import type { SentencesOf } from '../language/texts.js';
import { rangeOf } from '../language/words.js';
import type { Words } from '../language/words.js';
import type { FloatingHorizonEvents } from '../trace/events.js';
import type { Flag } from './state.js';
import { isLostBelow, metBy } from './state.js';

/** Whether a part of a segment is a point on a column. */
const isPoint = ({
  fromColumns: [first, last],
  toColumns: [, end],
}: FloatingHorizonEvents['draw_line']): boolean => first === last && first === end;

const columns = {
  en: { one: 'column', other: 'columns' },
  ru: { one: 'столбцом', other: 'столбцами' },
};

const where = {
  en: ([left, right]: readonly [number, number], words: Words): string =>
    left === right
      ? `over column ${words.short(left)}`
      : `between the columns ${words.short(left)} and ${words.short(right)}`,
  ru: ([left, right]: readonly [number, number], words: Words): string =>
    left === right
      ? `над столбцом ${words.short(left)}`
      : `между столбцами ${words.short(left)} и ${words.short(right)}`,
};

const names = {
  en: { upper: 'the upper horizon', lower: 'the lower horizon' },
  ru: { upper: 'с верхним горизонтом', lower: 'с нижним горизонтом' },
};

const flags: Bilingual<Readonly<Record<`${Flag}`, string>>> = {
  en: {
    1: 'visible (1): it is on the upper horizon or above it',
    '-1': 'visible (−1): it is on the lower horizon or below it',
    0: 'hidden (0): it is strictly between the horizons',
    2: 'visible (2): it is on both horizons, or there are none yet',
  },
  ru: {
    1: 'видна (1): она на верхнем горизонте или выше него',
    '-1': 'видна (−1): она на нижнем горизонте или ниже него',
    0: 'не видна (0): она строго между горизонтами',
    2: 'видна (2): она на обоих горизонтах, или их ещё нет',
  },
};

/** The printed text draws nothing between two such points (X-H1). */
const lostBelow = {
  en: 'on the lower horizon or below it (−1)',
  ru: '— на нижнем горизонте или ниже него (−1)',
};

export const sentences: SentencesOf<keyof FloatingHorizonEvents> = {
  horizons: {
    en: ({ upper, lower }, { short }) =>
      upper === undefined || lower === undefined
        ? 'There is no horizon over any column yet.'
        : `Over every column the upper horizon begins at ${short(upper)}, the lower one at ${short(lower)}.`,
    ru: ({ upper, lower }, { short }) =>
      upper === undefined || lower === undefined
        ? 'Ни над одним столбцом горизонта ещё нет.'
        : `Над каждым столбцом верхний горизонт начинается с ${short(upper)}, нижний — с ${short(lower)}.`,
  },
  curve: {
    en: ({ curve }) =>
      curve === 0 ? 'The first curve, 0, is the nearest.' : `Curve ${curve} is the next one.`,
    ru: ({ curve }) =>
      curve === 0 ? 'Первая кривая, 0, ближе всех.' : `Следующая кривая — ${curve}.`,
  },
  side_edge: {
    en: ({ at, sample }, { point }) =>
      `The ${at === 'FH3' ? 'left' : 'right'} side edge now ends at ${point(sample)}.`,
    ru: ({ at, sample }, { point }) =>
      `${at === 'FH3' ? 'Левое' : 'Правое'} боковое ребро дошло до ${point(sample)}.`,
  },
  visibility: {
    en: ({ x, flag }, { after, header, short }) => {
      const told = after.floatingHorizon?.height ?? null;
      const at = told?.x === x ? ` at ${short(told.y)}` : '';
      const isLost = isLostBelow(flag, header.edition);
      return `Over column ${short(x)} the curve${at} is ${isLost ? lostBelow.en : flags.en[flag]}.`;
    },
    ru: ({ x, flag }, { after, header, short }) => {
      const told = after.floatingHorizon?.height ?? null;
      const at = told?.x === x ? ` на высоте ${short(told.y)}` : '';
      const isLost = isLostBelow(flag, header.edition);
      return `Над столбцом ${short(x)} кривая${at} ${isLost ? lostBelow.ru : flags.ru[flag]}.`;
    },
  },
  intersection: {
    en: ({ at, point: met, columns: between }, words) => {
      const horizon = metBy(at, words.after.floatingHorizon ?? null);
      return `The segment meets ${horizon === null ? 'the horizon' : names.en[horizon]} at ${words.point(met)}, ${where.en(between, words)}.`;
    },
    ru: ({ at, point: met, columns: between }, words) => {
      const horizon = metBy(at, words.after.floatingHorizon ?? null);
      return `Отрезок встречается ${horizon === null ? 'с горизонтом' : names.ru[horizon]} в точке ${words.point(met)}, ${where.ru(between, words)}.`;
    },
  },
  draw_line: {
    en: (event, { point }) => {
      const { at, from, to } = event;
      if (isPoint(event)) return `The curve is visible at the point ${point(from)}.`;
      const why = {
        FH6: 'it is on one side all the way',
        FH7: 'then a horizon hides it, or it changes sides',
        FH8: 'before, a horizon hid it, or it was on the other side',
      }[at];
      return `The curve is drawn from ${point(from)} to ${point(to)}: ${why}.`;
    },
    ru: (event, { point }) => {
      const { at, from, to } = event;
      if (isPoint(event)) return `Кривая видна в точке ${point(from)}.`;
      const why = {
        FH6: 'весь путь она на одной стороне',
        FH7: 'дальше её закрывает горизонт, или она переходит на другую сторону',
        FH8: 'до того её закрывал горизонт, или она была на другой стороне',
      }[at];
      return `Кривая рисуется от ${point(from)} до ${point(to)}: ${why}.`;
    },
  },
  horizon: {
    en: ({ first, last, upper, lower }, words) => {
      if (last < first) return 'No column lies between: the horizons stay as they are.';
      const over =
        first === last
          ? `Column ${words.short(first)}`
          : `Columns ${words.short(first)} to ${words.short(last)}`;
      if (upper.length + lower.length === 0) return `${over}: both horizons stay as they are.`;
      const raised = `the upper horizon rises over ${words.counted(upper.length, columns.en)}`;
      const lowered = `the lower horizon falls over ${words.counted(lower.length, columns.en)}`;
      if (lower.length === 0) return `${over}: ${raised}.`;
      return upper.length === 0 ? `${over}: ${lowered}.` : `${over}: ${raised}, and ${lowered}.`;
    },
    ru: ({ first, last, upper, lower }, words) => {
      if (last < first) return 'Между ними нет ни одного столбца: горизонты прежние.';
      const over =
        first === last ? `Столбец ${words.short(first)}` : `Столбцы ${rangeOf(first, last)}`;
      if (upper.length + lower.length === 0) return `${over}: оба горизонта прежние.`;
      const raised = `верхний горизонт поднимается над ${words.counted(upper.length, columns.ru)}`;
      const lowered = `нижний горизонт опускается над ${words.counted(lower.length, columns.ru)}`;
      if (lower.length === 0) return `${over}: ${raised}.`;
      return upper.length === 0 ? `${over}: ${lowered}.` : `${over}: ${raised}, ${lowered}.`;
    },
  },
  height: {
    en: ({ x, y, upper, lower }, { short, shortApart }) => {
      if (upper === undefined || lower === undefined) {
        return `Over column ${short(x)} the curve is at ${short(y)}; no horizon is there.`;
      }
      const [own, above] = shortApart(y, upper);
      const [, below] = shortApart(y, lower);
      return `Over column ${short(x)} the curve is at ${own}; the upper horizon is at ${above}, the lower one at ${below}.`;
    },
    ru: ({ x, y, upper, lower }, { short, shortApart }) => {
      if (upper === undefined || lower === undefined) {
        return `Над столбцом ${short(x)} кривая на высоте ${short(y)}; горизонта там нет.`;
      }
      const [own, above] = shortApart(y, upper);
      const [, below] = shortApart(y, lower);
      return `Над столбцом ${short(x)} кривая на высоте ${own}; верхний горизонт на ${above}, нижний на ${below}.`;
    },
  },
  raise: {
    en: ({ x, y }, { short }) => `Over column ${short(x)} the upper horizon moves to ${short(y)}.`,
    ru: ({ x, y }, { short }) => `Над столбцом ${short(x)} верхний горизонт теперь на ${short(y)}.`,
  },
  lower: {
    en: ({ x, y }, { short }) => `Over column ${short(x)} the lower horizon moves to ${short(y)}.`,
    ru: ({ x, y }, { short }) => `Над столбцом ${short(x)} нижний горизонт теперь на ${short(y)}.`,
  },
  step: {
    en: ({ x, changes }, { short }) =>
      changes
        ? `Over column ${short(x)} the segment is on the other side of the horizon: they meet on the way here.`
        : `Over column ${short(x)} the segment is still on the same side of the horizon.`,
    ru: ({ x, changes }, { short }) =>
      changes
        ? `Над столбцом ${short(x)} отрезок уже по другую сторону горизонта: он пересёк его перед этим столбцом.`
        : `Над столбцом ${short(x)} отрезок по ту же сторону горизонта.`,
  },
};
