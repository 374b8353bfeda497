import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import { polygonName } from './parts.js';

/** The most rows shown: a list may be far longer than anyone reads. */
const mostRows = 200;
const mostChips = 12;
/** In a lecture hall: so many rows, or one less and the number of the others. */
export const mostInHall = 3;
/** The most rows on paper, where nobody can scroll. */
export const mostPrinted = 9;

function emptyOrMore(length: number, shown: number, { texts }: View): TemplateResult {
  if (length === 0) return html`<p class="empty">${texts.empty}</p>`;
  const more = (most: number, look: string): TemplateResult | typeof nothing =>
    length > most ? html`<p class="empty ${look}">${texts.more(length - most)}</p>` : nothing;
  return html`${more(shown, 'on-screen')} ${more(Math.min(shown, mostPrinted), 'on-paper')}`;
}

/** The number of rows shown of so many, where a hall has room for `room` lines. */
export function rowsShown(length: number, { hall }: View, room = mostInHall): number {
  if (hall !== true) return Math.min(length, mostRows);
  return length <= room ? length : Math.max(1, room - 1);
}

/** A table of the beginning of a list, and the number of further rows. */
export function rowsOf<T>(
  entries: readonly T[],
  row: (entry: T, index: number) => TemplateResult,
  view: View,
  look = '',
  room = mostInHall,
): TemplateResult {
  const shown = rowsShown(entries.length, view, room);
  return html`<table class="rows counted ${look}">
      <tbody>
        ${entries.slice(0, shown).map(row)}
      </tbody>
    </table>
    ${emptyOrMore(entries.length, shown, view)}`;
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
