import { point, short, shortApart } from '../i18n/ru/numbers.js';
import type { Sentences } from '../language/texts.js';
import { rangeOf } from '../language/words.js';
import { isPoint } from '../replay/lines.js';
import type { CurveEvents } from '../trace/events.js';
import type { Flag } from './events.js';
import { isLostBelow, metBy } from './sides.js';

const columns = { one: 'столбцом', other: 'столбцами' };

const where = ([left, right]: readonly [number, number]): string =>
  left === right
    ? `над столбцом ${short(left)}`
    : `между столбцами ${short(left)} и ${short(right)}`;

const names = { upper: 'с верхним горизонтом', lower: 'с нижним горизонтом' } as const;

const flags: Readonly<Record<`${Flag}`, string>> = {
  1: 'на верхнем горизонте или выше него: видна (1)',
  '-1': 'на нижнем горизонте или ниже него: видна (−1)',
  0: 'строго между горизонтами: не видна (0)',
  2: 'на обоих горизонтах, или их ещё нет: видна (2)',
};

/** Между двумя такими точками напечатанный текст ничего не рисует (X-H1). */
const lostBelow = 'на нижнем горизонте или ниже него (−1)';

export const sentences: Pick<Sentences, keyof CurveEvents> = {
  horizons: ({ upper, lower }) =>
    upper === undefined || lower === undefined
      ? 'Ни над одним столбцом горизонта ещё нет.'
      : `Над каждым столбцом верхний горизонт начинается с ${short(upper)}, нижний — с ${short(lower)}.`,
  curve: ({ curve }) =>
    curve === 0 ? 'Первая кривая, 0, ближе всех.' : `Следующая кривая — ${curve}.`,
  side_edge: ({ at, sample }) =>
    `${at === 'FH3' ? 'Левое' : 'Правое'} боковое ребро дошло до ${point(sample)}.`,
  visibility: ({ x, flag }, { after, header }) => {
    const told = after.horizon?.told ?? null;
    const at = told?.x === x ? ` на высоте ${short(told.y)}` : '';
    const isLost = isLostBelow(flag, header.edition);
    return `Над столбцом ${short(x)} кривая${at} — ${isLost ? lostBelow : flags[flag]}.`;
  },
  intersection: ({ at, point: met, columns: between }, { after }) => {
    const horizon = metBy(at, after.horizon ?? null);
    return `Отрезок встречается ${horizon === null ? 'с горизонтом' : names[horizon]} в ${point(met)}, ${where(between)}.`;
  },
  draw_line: (event) => {
    const { at, from, to } = event;
    if (isPoint(event)) return `Кривая видна в точке ${point(from)}.`;
    const why = {
      FH6: 'весь путь она на одной стороне',
      FH7: 'дальше её закрывает горизонт, или она переходит на другую сторону',
      FH8: 'до того её закрывал горизонт, или она была на другой стороне',
    }[at];
    return `Кривая рисуется от ${point(from)} до ${point(to)}: ${why}.`;
  },
  horizon: ({ first, last, upper, lower }, words) => {
    if (last < first) return 'Между ними нет ни одного столбца: горизонты прежние.';
    const over = first === last ? `Столбец ${short(first)}` : `Столбцы ${rangeOf(first, last)}`;
    if (upper.length + lower.length === 0) return `${over}: оба горизонта прежние.`;
    const raised = `верхний горизонт поднимается над ${words.counted(upper.length, columns)}`;
    const lowered = `нижний горизонт опускается над ${words.counted(lower.length, columns)}`;
    if (lower.length === 0) return `${over}: ${raised}.`;
    return upper.length === 0 ? `${over}: ${lowered}.` : `${over}: ${raised}, ${lowered}.`;
  },
  height: ({ x, y, upper, lower }) => {
    if (upper === undefined || lower === undefined) {
      return `Над столбцом ${short(x)} кривая на высоте ${short(y)}; горизонта там нет.`;
    }
    const [own, above] = shortApart(y, upper);
    const [, below] = shortApart(y, lower);
    return `Над столбцом ${short(x)} кривая на высоте ${own}; верхний горизонт на ${above}, нижний на ${below}.`;
  },
  raise: ({ x, y }) => `Над столбцом ${short(x)} верхний горизонт теперь на ${short(y)}.`,
  lower: ({ x, y }) => `Над столбцом ${short(x)} нижний горизонт теперь на ${short(y)}.`,
  step: ({ x, changes }) =>
    changes
      ? `Над столбцом ${short(x)} отрезок по другую сторону горизонта: встреча на пути сюда.`
      : `Над столбцом ${short(x)} отрезок по ту же сторону горизонта.`,
};
