import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { withTerms } from '../elements/term.js';
import { FirstTerms } from '../i18n/glossary.js';
import type { Term } from '../i18n/glossary.js';
import type { Language } from '../language/language.js';
import { blocks } from './blocks.js';
import { inlines, plainWords } from './inlines.js';
import type { Blocks, Inlines, Question, Source } from './story.js';
import { withoutPlaces, withoutTerms } from './context.js';
import type { TextContext } from './context.js';

/** What stands below the title, folded to a line: the time, what comes first, the terms and the goals of the lesson. */
export function opening(context: TextContext, language: Language): TemplateResult | typeof nothing {
  const { lesson, story, texts } = context;
  const terms = introducedIn(story.blocks, language);
  const first = prerequisites(context, language);
  const facts: readonly (readonly [string, unknown])[] = [
    ...(lesson.minutes === undefined ? [] : [[texts.time, texts.minutes(lesson.minutes)] as const]),
    ...(first.length === 0 ? [] : [[texts.prerequisites, first] as const]),
    ...(terms.length === 0 ? [] : [[texts.terms, termList(terms, language)] as const]),
  ];
  if (facts.length === 0 && story.goals.length === 0) return nothing;
  const about = lesson.minutes === undefined ? texts.about : texts.aboutFor(lesson.minutes);
  // What is folded stays outside, since no style can unfold it on paper in every browser.
  return html`<details class="about">
      <summary>${about}</summary>
    </details>
    <section class="frame" aria-label=${texts.about}>
      <dl>
        ${facts.map(
          ([name, value]) =>
            html`<div>
              <dt>${name}</dt>
              <dd>${value}</dd>
            </div>`,
        )}
      </dl>
      ${story.goals.length === 0 ? nothing : goals(context)}
    </section>`;
}

function goals(context: TextContext): TemplateResult {
  const { story, texts } = context;
  return html`<p class="label">${texts.goals}</p>
    <ul>
      ${story.goals.map((goal) => html`<li>${inlines(goal, withoutTerms(context))}</li>`)}
    </ul>`;
}

/** The lessons that come first, and what else the reader must know, as the items of a list. */
function prerequisites({ lesson, texts, addressOf }: TextContext, language: Language): unknown[] {
  if (lesson.prerequisites === undefined) return [];
  const lessons = lesson.prerequisites.map(({ id, title }) => {
    const address = addressOf(id);
    const name = title[language];
    return html`<li>
      ${address === null ? name : html`<a class="lesson" href=${address}>${name}</a>`}
    </li>`;
  });
  const assumed = lesson.assumes?.[language];
  const all = assumed === undefined ? lessons : [...lessons, html`<li>${assumed}</li>`];
  return all.length === 0
    ? [texts.noPrerequisites]
    : [
        html`<ul>
          ${all}
        </ul>`,
      ];
}

/** The terms that a text defines: they stand there in bold. */
export function introducedIn(all: Blocks, language: Language): readonly Term[] {
  const strong = boldIn(all).flatMap((words) => new FirstTerms(language).split(words));
  const terms = strong.flatMap(({ term }) => (term === null ? [] : [term]));
  return [...new Set(terms)];
}

function boldIn(all: Blocks): readonly string[] {
  return all.flatMap((block) => {
    if (block.is === 'paragraph') return boldWords(block.text);
    if (block.is === 'list') return boldIn(block.items.flat());
    if (block.is === 'quote') return boldIn(block.blocks);
    if (block.is === 'table') return [block.head, ...block.rows].flat().flatMap(boldWords);
    return [];
  });
}

const boldWords = (text: Inlines): readonly string[] =>
  text.flatMap((inline) =>
    typeof inline !== 'string' && inline.is === 'strong' ? [plainWords(inline.text)] : [],
  );

function termList(terms: readonly Term[], language: Language): unknown {
  const shown = new FirstTerms(language);
  const comma = (i: number): string => (i < terms.length - 1 ? ',' : '');
  return terms.map(
    (term, i) => html`<span class="term">${withTerms(term.term, shown)}${comma(i)}</span> `,
  );
}

/** The publications on which the lesson rests. */
export function sources(
  { lesson, texts }: TextContext,
  language: Language,
): TemplateResult | typeof nothing {
  const all = lesson.sources ?? [];
  if (all.length === 0) return nothing;
  const reference = ({
    authors,
    year,
    title,
    url,
    chapter,
    translations,
    ...more
  }: Source): TemplateResult => {
    const name = html`<cite>${title}</cite>`;
    const linked =
      url === undefined
        ? name
        : html`<a class="link" href=${url} target="_blank" rel="noopener noreferrer">${name}</a>`;
    const translated = translations?.[language];
    return html`<li>
      ${authors} (${year}). ${linked}.
      ${more.in}${chapter === undefined ? '' : `, ${texts.chapter(chapter)}`}.${translated === undefined ? '' : ` ${translated}`}
    </li>`;
  };
  return html`<section class="sources">
    <h3>${texts.sources}</h3>
    <ul>
      ${all.map(reference)}
    </ul>
  </section>`;
}

/** The answers together, for the end of the printed text. */
export function printedAnswers(context: TextContext): TemplateResult | typeof nothing {
  const { story, texts } = context;
  const answered = story.blocks.filter(
    (block): block is Question & { readonly answer: Blocks } =>
      (block.is === 'question' || block.is === 'exercise') && block.answer !== undefined,
  );
  if (answered.length === 0) return nothing;
  return html`<section class="answers">
    <h3>${texts.answers}</h3>
    ${answered.map(
      ({ is, number, answer }) =>
        html`<p class="number">${texts[is](number)}</p>
          ${blocks(answer, withoutPlaces(context))}`,
    )}
  </section>`;
}
