import type { TravelTexts } from '../../language/texts.js';

export const travel: TravelTexts = {
  procedure: 'Процедура',
  over: 'Через вызов',
  overBack: 'Назад через вызов',
  out: 'Из процедуры, к её результату',
  outBack: 'Назад из процедуры, к её вызову',
  goTo: 'Перейти',
  next: 'К следующему',
  previous: 'К предыдущему',
  goals: {
    split: 'деление окна',
    ael: 'изменение AEL',
    curve: 'кривая',
    crossing: 'встреча с горизонтом',
    list: 'список из стека',
    region: 'видимая область',
    wrong: 'неверное решение',
    pixel: 'шаг выбранного пикселя',
    bookmark: 'закладка',
  },
  ofPolygon: 'шаг многоугольника',
  noGoal: 'нет',
};
