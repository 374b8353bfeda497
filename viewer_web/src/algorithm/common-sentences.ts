import { faultReason } from '../language/fault-reason.js';
import type { SentencesOf } from '../language/texts.js';
import type { CommonEvents } from '../trace/events.js';

/** The sentences of the events that all algorithms have. */
export const commonSentences: SentencesOf<keyof CommonEvents> = {
  plane: {
    en: ({ polygon, plane }, { texts }) =>
      `The plane of ${polygon}: (a, b, c, d) = (${texts.numbers.list(plane)}).`,
    ru: ({ polygon, plane }, { texts }) =>
      `Плоскость ${polygon}: (a; b; c; d) = (${texts.numbers.list(plane)}).`,
  },
  call: {
    en: ({ of }, { texts }) => `${of} begins: ${texts.purposes[of]}`,
    ru: ({ of }, { texts }) => `Начинается ${of}: ${texts.purposes[of]}`,
  },
  depth: {
    en: ({ polygon, point: at, z }, { point, short }) =>
      `At the point ${point(at)} the plane of ${polygon} has depth ${short(z)}.`,
    ru: ({ polygon, point: at, z }, { point, short }) =>
      `В точке ${point(at)} глубина плоскости ${polygon} равна ${short(z)}.`,
  },
  fault: {
    en: ({ reason, x, y }, { point }) =>
      x === undefined || y === undefined
        ? `The printed text fails here: ${reason}. The run ends.`
        : `The printed text fails here, at pixel ${point([x, y])}: ${reason}.`,
    ru: ({ reason, x, y }, { point }) =>
      x === undefined || y === undefined
        ? `Напечатанный текст здесь ошибается: ${faultReason('ru', reason)}. Прогон окончен.`
        : `Напечатанный текст здесь, в пикселе ${point([x, y])}, ошибается: ${faultReason('ru', reason)}.`,
  },
  disagree: {
    en: ({ of, taken, exact, cause }, { texts: { exact: say } }) =>
      `Decided wrongly: ${say.decided[of]}. Computed: ${say.answer(taken)}; exact: ${say.answer(exact)}. ${say.causes[cause]}`,
    ru: ({ of, taken, exact, cause }, { texts: { exact: say } }) =>
      `Решено неверно: ${say.decided[of]}. Вычислено: ${say.answer(taken)}; точный ответ: ${say.answer(exact)}. ${say.causes[cause]}`,
  },
};
