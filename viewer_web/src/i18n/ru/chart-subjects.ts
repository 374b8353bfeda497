import type { ChartTexts } from '../../language/texts.js';

export const subjects: ChartTexts['subjects'] = {
  scenes: {
    show: 'Сцена',
    showOne: 'Чтобы воспроизвести прогон, покажите одну сцену.',
    fixed: 'float, double…',
    missingSomewhere: (runs) =>
      `Не показаны, так как числа для них есть не у каждой сцены: ${runs}.`,
    noneRight: 'Ни один из показанных прогонов не верен во всех пикселях.',
  },
  surfaces: {
    show: 'Поверхность',
    showOne: 'Чтобы воспроизвести прогон, покажите одну поверхность.',
    fixed: 'как задано',
    missingSomewhere: (runs) =>
      `Не показаны, так как такие отсчёты есть не у каждой поверхности: ${runs}.`,
    noneRight: 'Ни один из показанных прогонов не верен во всех столбцах.',
  },
};
