import type { ReaderTexts } from '../../language/reader-texts.js';

export const reader: ReaderTexts = {
  text: 'Текст',
  hide: 'Скрыть текст',
  contents: 'Содержание',
  follow: 'Следовать за текстом',
  followHint:
    'При прокрутке прогон переходит к шагу, о котором вы читаете. Ссылка в тексте ведёт к нему всегда.',
  step: (step) => `шаг ${step}`,
  pin: (step, run) => `Шаг ${step}: ${run}`,
  linkHere: (heading) => `Ссылка на «${heading}»`,
  about: 'Об уроке',
  time: 'Время на занятии',
  minutes: (minutes) => `${minutes} мин без упражнений`,
  prerequisites: 'Что нужно знать',
  noPrerequisites: 'ничего особого',
  terms: 'Новые термины',
  goals: 'После этого урока вы сможете',
  sources: 'Источники',
  chapter: (chapter) => `глава ${chapter}`,
  question: (number) => `Вопрос ${number}`,
  exercise: (number) => `Упражнение ${number}`,
  answer: 'Ответ',
  answers: 'Ответы',
  copy: 'Копировать',
  copied: 'Скопировано',
  previous: 'Предыдущий урок',
  next: 'Следующий урок',
  otherLessons: 'Другие уроки',
  refused: (where, reason) =>
    `Текст этого урока не читается${where === '' ? '' : `, место ${where}`}: ${reason}. Прогоны урока доступны, как и прежде.`,
  broken: 'Текст этого урока не читается. Прогоны урока доступны, как и прежде.',
};
