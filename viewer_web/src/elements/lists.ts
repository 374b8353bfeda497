import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import { polygonName } from './parts.js';

/** The most rows shown: a list may be far longer than anyone reads. */
const mostRows = 200;
const mostChips = 12;
/** The most rows on paper, where nobody can scroll. */
export const mostPrinted = 9;

function emptyOrMore(length: number, { texts }: View): TemplateResult {
  if (length === 0) return html`<p class="empty">${texts.empty}</p>`;
  const more = (most: number, look: string): TemplateResult | typeof nothing =>
    length > most ? html`<p class="empty ${look}">${texts.more(length - most)}</p>` : nothing;
  return html`${more(mostRows, 'on-screen')} ${more(mostPrinted, 'on-paper')}`;
}

/** A table of the beginning of a list, and the number of further rows. */
export function rowsOf<T>(
  entries: readonly T[],
  row: (entry: T, index: number) => TemplateResult,
  view: View,
  look = '',
): TemplateResult {
  return html`<table class="rows counted ${look}">
      <tbody>
        ${entries.slice(0, mostRows).map(row)}
      </tbody>
    </table>
    ${emptyOrMore(entries.length, view)}`;
}

/** Rows in a scrolling box. */
export function listOf<T>(
  label: string,
  look: string,
  entries: readonly T[],
  row: (entry: T, index: number) => TemplateResult,
  view: View,
): TemplateResult {
  return html`<div class="list ${look}" tabindex="0" role="region" aria-label=${label}>
    ${rowsOf(entries, row, view)}
  </div>`;
}

/** The polygons of a list on the stack, in one line. */
export function chipsCell(ids: readonly string[], view: View): TemplateResult {
  return html`<td class="chips">
    ${ids.slice(0, mostChips).map((id) => html`<span class="chip">${polygonName(id, view)}</span>`)}
  </td>`;
}
