import type { TourTexts, VerdictTexts, WordTexts } from '../../language/texts.js';
import { counted } from '../../language/words.js';
import type { PluralForms } from '../../language/words.js';

const rules = new Intl.PluralRules('ru');
const count = (n: number, forms: PluralForms): string => counted(n, forms, rules);

export const words: WordTexts = {
  explain: 'Что значат эти слова',
  editions: {
    corrected: 'Процедуры из учебника, в которых исправлены ошибки.',
    printed: 'Процедуры в точности как в учебнике, вместе с ошибками.',
    defects: 'Исправленные процедуры, в которые возвращены отдельные ошибки учебника.',
    mistake: 'Исправленные процедуры, в которых сделана одна типичная ошибка.',
  },
  details: {
    windows: 'В трассе только главные шаги.',
    polygons: 'В трассе видно, что делается с каждым многоугольником.',
    signs: 'В трассе всё, вплоть до знака каждого решения.',
  },
};

export const verdict: VerdictTexts = {
  finished: 'Готово',
  pixels: (n) => count(n, { one: 'пиксель', few: 'пикселя', other: 'пикселей' }),
  allRight: 'все как в точной арифметике',
  someWrong: (n) => `не как в точной арифметике: ${n}`,
  someOther: (n) => `не как в правильном изображении: ${n}`,
  comparing: 'идёт сверка с точной арифметикой…',
  allColorsRight: 'все цвета — как в точной арифметике',
  notCompared: 'с точной арифметикой не сверено',
  decisionsRight: 'все решения как в точной арифметике',
  decisionsRightBut: 'все решения как в точной арифметике, но текст не исправлен',
  decisionsWrong: (n) => `шагов с неверными решениями: ${n}`,
  windows: (n) => count(n, { one: 'окно', few: 'окна', other: 'окон' }),
  comparisons: (n) =>
    count(n, {
      one: 'сравнение глубин',
      few: 'сравнения глубин',
      other: 'сравнений глубин',
    }),
  regions: (n) =>
    count(n, {
      one: 'видимая область',
      few: 'видимые области',
      other: 'видимых областей',
    }),
  curves: (n) => count(n, { one: 'кривая', few: 'кривые', other: 'кривых' }),
};

export const tour: TourTexts = {
  about: 'vidno пошагово выполняет алгоритмы удаления невидимых поверхностей.',
  offer: 'Впервые здесь? Обзор',
  again: 'Показать, что здесь где',
  next: 'Дальше',
  done: 'Готово',
  leave: 'Закончить',
  at: (n, of) => `${n} из ${of}`,
  steps: [
    {
      title: 'Изображение',
      text: 'Его построил прогон. Наведите указатель на пиксель, чтобы узнать его цвет и глубину; щелчок покажет, почему цвет именно такой.',
    },
    {
      title: 'Прогон',
      text: 'Пустите его с начала или шагайте клавишами со стрелками. Фраза говорит, что произошло и почему.',
    },
    {
      title: 'Процедура',
      text: 'Текущая строка отмечена, рядом — её значения.',
    },
    {
      title: 'Текст',
      text: 'Синие слова с точечным подчёркиванием ведут к шагу, о котором идёт речь. Всё, что известно о шаге, есть в мастерской.',
    },
  ],
};
