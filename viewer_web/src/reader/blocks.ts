import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import type { Language } from '../language/language.js';
import { excerpt } from '../listing/listings.js';
import './command.js';
import { formula, inlines, plainWords } from './inlines.js';
import type {
  Align,
  Block,
  Blocks,
  Figure,
  Heading,
  Inlines,
  PrintedListing,
  Question,
  Table,
} from './story.js';
import { withoutTerms } from './context.js';
import type { TextContext } from './context.js';

/** Procedures in the text of a lesson, line by line with their labels. */
function listing({ names, edition }: PrintedListing, language: Language): TemplateResult {
  return html`<div class="listing">
    ${excerpt(names, edition, language).map(
      ({ name, title, takes, lines }) =>
        html`<p><b>${name}</b>(${takes}) <span class="title">${title}</span></p>
          <ol>
            ${lines.map(
              ({ at, indent, text, defects }) =>
                html`<li>
                  <span class="at">${at}</span>
                  <code .style=${`--indent: ${indent}`}>${text}</code>
                  <span class="defects">${defects.join(' ')}</span>
                </li>`,
            )}
          </ol>`,
    )}
  </div>`;
}

/** A paragraph of at most this many characters takes three lines in print. */
const longestShort = 280;

/** The blocks of a story, one below the other. */
export function blocks(all: Blocks, context: TextContext): readonly TemplateResult[] {
  return withGalleries(all).map((group) => {
    const parts = group.map((block) => templateOf(block, context));
    return parts.length === 1 ? html`${parts}` : html`<div class="gallery">${parts}</div>`;
  });
}

/** Puts figures that follow each other into one group, so that they stand side by side. */
function withGalleries(all: Blocks): readonly Blocks[] {
  const groups: Block[][] = [];
  for (const block of all) {
    const last = groups.at(-1);
    if (block.is === 'figure' && last?.[0]?.is === 'figure') last.push(block);
    else groups.push([block]);
  }
  return groups;
}

function templateOf(block: Block, context: TextContext): TemplateResult {
  switch (block.is) {
    case 'heading':
      return heading(block, context);
    case 'paragraph':
      return html`<p class=${plainWords(block.text).length > longestShort ? nothing : 'short'}>
        ${inlines(block.text, context)}
      </p>`;
    case 'list': {
      const items = block.items.map((item) => html`<li>${blocks(item, context)}</li>`);
      return block.ordered
        ? html`<ol>
            ${items}
          </ol>`
        : html`<ul>
            ${items}
          </ul>`;
    }
    case 'quote':
      return html`<blockquote>${blocks(block.blocks, context)}</blockquote>`;
    case 'question':
    case 'exercise':
      return question(block, context);
    case 'code':
      return block.language === 'sh'
        ? html`<vidno-command .text=${block.text} .texts=${context.texts}></vidno-command>`
        : html`<pre tabindex="0"><code>${block.text}</code></pre>`;
    case 'formula':
      return html`<div class="formula" tabindex="0">${formula(block.tex, true)}</div>`;
    case 'figure':
      return figure(block, context);
    case 'table':
      return table(block, context);
    case 'listing':
      return listing(block, context.language);
  }
}

function heading(block: Heading, context: TextContext): TemplateResult {
  const { story, lesson, addressOf, texts } = context;
  const place = story.places.get(block) ?? '';
  const address = addressOf(lesson.id, place) ?? nothing;
  context.terms?.forget();
  const words = html`${inlines(block.text, withoutTerms(context))}
    <a class="anchor" href=${address} aria-label=${texts.linkHere(plainWords(block.text))}>#</a>`;
  return block.level === 2
    ? html`<h3 data-place=${place} tabindex="-1">${words}</h3>`
    : html`<h4 data-place=${place} tabindex="-1">${words}</h4>`;
}

function question(
  { is, number, blocks: asked, answer }: Question,
  context: TextContext,
): TemplateResult {
  const { texts } = context;
  const name = texts[is](number);
  return html`<section class="question ${is}" aria-label=${name}>
    <p class="number">${name}</p>
    ${blocks(asked, context)}
    ${
      answer === undefined
        ? nothing
        : html`<details>
            <summary>${texts.answer}</summary>
            <div class="answer">${blocks(answer, context)}</div>
          </details>`
    }
  </section>`;
}

function figure({ caption, command, file }: Figure, context: TextContext): TemplateResult {
  const svg = context.story.figures.get(file);
  const image = (drawing: string): TemplateResult =>
    html`<img src=${drawing} alt=${plainWords(caption)} />`;
  return html`<figure>
    ${svg === undefined ? nothing : image(context.drawingOf(svg))}
    <figcaption>${inlines(caption, withoutTerms(context))}</figcaption>
    <vidno-command small .text=${command} .texts=${context.texts}></vidno-command>
  </figure>`;
}

function table({ head, align, rows }: Table, context: TextContext): TemplateResult {
  const cell = (tag: 'th' | 'td') => (text: Inlines, column: number) => {
    const words = inlines(text, context);
    const side: Align = align[column] ?? '';
    return tag === 'th'
      ? html`<th scope="col" class=${side}>${words}</th>`
      : html`<td class=${side}>${words}</td>`;
  };
  return html`<div class="table" tabindex="0">
    <table>
      <thead>
        <tr>
          ${head.map(cell('th'))}
        </tr>
      </thead>
      <tbody>
        ${rows.map(
          (row) =>
            html`<tr>
              ${row.map(cell('td'))}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`;
}
