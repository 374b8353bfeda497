import { html } from 'lit';
import type { TemplateResult } from 'lit';
import type { Language } from '../language/language.js';
import { excerpt } from '../listing/listings.js';
import type { PrintedListing } from './story.js';

/** Procedures in the text of a lesson, line by line with their labels. */
export function listing({ names, edition }: PrintedListing, language: Language): TemplateResult {
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
