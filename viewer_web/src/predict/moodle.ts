import { algorithmOf } from '../algorithm/algorithm.js';
import { viewOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { toBase64 } from '../base/base64.js';
import { element, escaped } from '../base/markup.js';
import { texts } from '../i18n/index.js';
import { editionName } from '../language/family-texts.js';
import type { Language } from '../language/language.js';
import { nameIn } from '../language/scene-name.js';
import type { Trace } from '../replay/trace.js';
import { clozeOf, inert } from './cloze.js';
import { factsOf } from './facts.js';
import type { Question } from './question.js';
import { reasonsOf, sayIntro } from './say.js';
import { spread } from './spread.js';

/** The number of questions by default. */
export const usualCount = 20;

const text = (content: string): string => element('text', [], escaped(content));

function questionText(view: View, question: Question, file: string): string {
  const { texts: page, step, language } = view;
  const image = { src: `@@PLUGINFILE@@/${file}`, alt: `${page.picture}, ${page.step} ${step}` };
  const rows = factsOf(view, question).map((fact) =>
    element('tr', [], `<th scope="row">${inert(fact[0])}</th><td>${inert(fact[1])}</td>`),
  );
  return [
    element('p', [], inert(sayIntro(question, language))),
    element('p', [], element('img', Object.entries({ ...image, class: 'img-fluid' }))),
    element('table', [['class', 'table table-sm']], element('tbody', [], rows.join(''))),
    clozeOf(question, language),
  ].join('');
}

function feedback(trace: Trace, question: Question, language: Language): string {
  const { page } = texts[language];
  const reasons = reasonsOf(trace, question, language).map(({ step, said }) =>
    element('li', [], inert(`${page.step} ${step}: ${said}`)),
  );
  return element('ol', [], reasons.join(''));
}

function questionXml(trace: Trace, question: Question, language: Language): string {
  const { step, kind } = question;
  const view = viewOf(trace, step, { language, pixel: null, pointed: null });
  const file = `step-${step}.svg`;
  const picture = toBase64(new TextEncoder().encode(algorithmOf(view.header).figure(view)));
  const asked =
    text(questionText(view, question, file)) +
    element('file', Object.entries({ name: file, path: '/', encoding: 'base64' }), picture);
  const name = `${view.texts.step} ${step}: ${texts[language].predict.kinds[kind]}`;
  return element(
    'question',
    [['type', 'cloze']],
    element('name', [], text(name)) +
      element('questiontext', [['format', 'html']], asked) +
      element('generalfeedback', [['format', 'html']], text(feedback(trace, question, language))),
  );
}

/** The path of the category in Moodle. A slash in a name would begin a subcategory. */
function category({ header }: Trace, language: Language): string {
  const { scene, method, kernel, edition } = header;
  const { methods, editions } = texts[language].page;
  const run = [
    'vidno',
    nameIn(language, scene.name),
    methods[method],
    kernel,
    editionName(editions, edition),
  ];
  const name = run.filter(Boolean).join(' · ').replaceAll('/', '//');
  const path = element('category', [], text(`$course$/top/${name}`));
  return element('question', [['type', 'category']], path);
}

/**
 * At most the given number of questions of a run, each with all data for its answer, for the question bank of Moodle in its
 * XML format (https://docs.moodle.org/en/Moodle_XML_format); null if there are none. May leave the timeline at any step.
 */
export function moodleXml(trace: Trace, language: Language, count = usualCount): string | null {
  const questions = spread(trace, count);
  if (questions.length === 0) return null;
  const written = questions.map((question) => questionXml(trace, question, language));
  const quiz = element('quiz', [], `\n${category(trace, language)}${written.join('')}`);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${quiz}`;
}
