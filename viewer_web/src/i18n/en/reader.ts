import type { ReaderTexts } from '../../language/reader-texts.js';

export const reader: ReaderTexts = {
  text: 'Text',
  hide: 'Hide the text',
  contents: 'Contents',
  follow: 'Follow the text',
  followHint:
    'As you scroll, the run goes to the step that you read about. A link in the text takes it there in any case.',
  step: (step) => `step ${step}`,
  pin: (step, run) => `Step ${step}: ${run}`,
  linkHere: (heading) => `Link to “${heading}”`,
  about: 'About this lesson',
  time: 'Time in class',
  minutes: (minutes) => `${minutes} minutes, without the exercises`,
  prerequisites: 'Prerequisites',
  noPrerequisites: 'none',
  terms: 'New terms',
  goals: 'After this lesson you can',
  sources: 'Sources',
  chapter: (chapter) => `chapter ${chapter}`,
  question: (number) => `Question ${number}`,
  exercise: (number) => `Exercise ${number}`,
  answer: 'Answer',
  answers: 'Answers',
  copy: 'Copy',
  copied: 'Copied',
  previous: 'Previous lesson',
  next: 'Next lesson',
  otherLessons: 'Other lessons',
  refused: (where, reason) =>
    `The text of this lesson cannot be read${where === '' ? '' : ` at ${where}`}: ${reason}. Its runs still work.`,
  broken: 'The text of this lesson cannot be read. Its runs still work.',
};
