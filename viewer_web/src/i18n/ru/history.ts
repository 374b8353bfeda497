import type { HistoryTexts } from '../../language/texts.js';
import { approximately } from '../../language/words.js';
import { short } from './numbers.js';

export const history: HistoryTexts = {
  pixel: 'Пиксель',
  at: (x, y) => `Пиксель (${x}; ${y})`,
  spoken: ([x, y], { color, owners: { polygons, background }, depth, isStored }) => {
    const owner = [...polygons, ...(background ? ['фон'] : [])].join(' или ');
    const painted = color === null ? ['ещё не закрашен'] : [owner, color].filter(Boolean);
    const depths =
      depth === null ? [] : [`глубина ${isStored ? short(depth) : approximately(short(depth))}`];
    return `Пиксель (${x}; ${y}): ${[...painted, ...depths].join(', ')}`;
  },
  hint: (key) =>
    `Щёлкните по пикселю изображения${key === null ? '' : ` или нажмите ${key}`}: здесь будет всё, что его касалось, и почему у него такой цвет.`,
  how: 'Стрелки — другой пиксель, с Shift — через десять. Enter показывает историю пикселя. Escape — выход.',
  forget: 'Забыть пиксель',
  entries: 'Всё, что касалось пикселя',
  outcomes: { pass: 'да', fail: 'нет', paint: 'закрашен', wrong: 'неверно', note: '' },
  painted: (step) => `Закрашен на шаге ${step}`,
  unpainted: 'Его ничто не закрасило.',
  reading: 'Просмотр трассы…',
  earlier: (n) => `раньше: ${n}`,
  later: (n) => `позже: ${n}`,
};
