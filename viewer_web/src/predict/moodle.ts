import { algorithmOf } from '../algorithm/algorithm.js';
import { viewOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { toBase64 } from '../base/base64.js';
import { element, escaped } from '../base/markup.js';
import { texts } from '../i18n/index.js';
import { editionName } from '../language/family.js';
import type { Language } from '../language/language.js';
import { nameIn } from '../language/scene-name.js';
import type { Trace } from '../replay/trace.js';
import { clozeOf, inert } from './cloze.js';
import { factsOf } from './facts.js';
import type { Kind, Question } from './question.js';
import { kindsOf, nextQuestion } from './questions.js';
import { reasonsOf, sayIntro } from './say.js';

/** At most the given number of questions of a kind, spread over the run. */
function paced(trace: Trace, kind: Kind, count: number): readonly Question[] {
  const stride = trace.timeline.length / count;
  const wanted = new Set([kind]);
  const found: Question[] = [];
  let next = nextQuestion(trace, 1, wanted, []);
  while (next !== null) {
    found.push(next);
    const from = Math.max(next.until, Math.ceil(next.step + stride));
    next = nextQuestion(trace, from, wanted, []);
  }
  return found;
}

/** The given number of items, spread over a whole list. */
const thinned = <T>(list: readonly T[], count: number): readonly T[] =>
  list.filter(
    (_, i) => Math.floor((i * count) / list.length) !== Math.floor(((i - 1) * count) / list.length),
  );

/** At most the given number of questions from the whole run, evenly by kind; always the same ones. */
export function spread(trace: Trace, count: number): readonly Question[] {
  const byKind = kindsOf(trace.header)
    .map((kind) => paced(trace, kind, count))
    .sort((a, b) => a.length - b.length);
  const chosen: Question[] = [];
  // The rare kinds come first, and the others share the rest.
  byKind.forEach((questions, i) => {
    const share = Math.floor((count - chosen.length) / (byKind.length - i));
    chosen.push(...thinned(questions, Math.min(share, questions.length)));
  });
  return chosen.sort((a, b) => a.step - b.step);
}

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
