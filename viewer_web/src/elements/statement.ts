import { html, type TemplateResult } from 'lit';
import { sentencesOf } from '../language/stated.js';
import type { Stated } from '../language/stated.js';

/** What the library says of a step, what is so instead in red. `show` makes what is shown of a line. */
export function statement(
  text: Stated,
  show: (line: string) => unknown = (line) => line,
): TemplateResult {
  const [computed = '', exact] = sentencesOf(text);
  if (exact === undefined) return html`${show(computed)}`;
  return html`${show(computed)} <strong class="exactly">${show(exact)}</strong>`;
}
