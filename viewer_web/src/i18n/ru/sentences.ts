import type { Sentences } from '../../language/texts.js';
import type { CommonEvents } from '../../trace/events.js';
import { exact } from './exact.js';
import { list, point, short } from './numbers.js';
import { purposes } from './page.js';

const { answer, causes, decided } = exact;

/** The sentences of the events that all algorithms tell. */
export const sentences: Pick<Sentences, keyof CommonEvents> = {
  plane: ({ polygon, plane }) => `Плоскость ${polygon}: a, b, c, d = ${list(plane)}.`,
  call: ({ of }) => `Начинается ${of}: ${purposes[of]}`,
  depth: ({ polygon, point: at, z }) =>
    `В точке ${point(at)} глубина плоскости ${polygon} равна ${short(z)}.`,
  fault: ({ reason, x, y }) =>
    x === undefined || y === undefined
      ? `Напечатанный текст здесь ошибается: ${reason}. Прогон окончен.`
      : `Напечатанный текст здесь ошибается: ${reason}, пиксель ${point([x, y])}.`,
  disagree: ({ of, taken, exact, cause }) =>
    `Неверно, ${decided[of]}: вычислено ${answer(taken)}, точно ${answer(exact)}. ${causes[cause]}`,
};
