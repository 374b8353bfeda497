import { html, type TemplateResult } from 'lit';

/**
 * What the library says of a step: one line, or what the run computed and, on a second line, what is so instead. `show` makes
 * what is shown of a line.
 */
export function statement(
  text: string,
  show: (line: string) => unknown = (line) => line,
): TemplateResult {
  const [computed = '', exact] = text.split('\n');
  if (exact === undefined) return html`${show(computed)}`;
  return html`${show(computed)} <strong class="exactly">${show(exact)}</strong>`;
}

/** The same as plain text. */
export const inOneLine = (text: string): string => text.replace('\n', ' ');

/** Whether something else is so than the run computed. */
export const isCorrected = (text: string): boolean => text.includes('\n');
