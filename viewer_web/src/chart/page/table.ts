import { css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import type { Amount } from '../words.js';

/** A number in a table, and below it the counted value. */
export function amount([shown, counted]: Amount): TemplateResult {
  return html`<td class="number">
    ${shown}${counted === null ? nothing : html`<small>${counted}</small>`}
  </td>`;
}

/** The tables of runs beside the plot. A run is a button that chooses its point. */
export const tableStyle = css`
  table {
    width: 100%;
    border-collapse: collapse;
  }
  th,
  td {
    padding: 0.3em 0.6em 0.3em 0;
    border-top: 1px solid var(--line);
    text-align: left;
    font-weight: 400;
    vertical-align: top;
  }
  thead > tr > * {
    border-top: 0;
    font-size: 0.8125em;
    color: var(--soft);
  }
  td.number {
    font-size: 0.9375em;
    white-space: nowrap;
  }
  small {
    display: block;
    font-size: 0.8125em;
    color: var(--soft);
  }
  [aria-current='true'] small {
    color: var(--ink);
  }
  button {
    min-height: 1.6em;
    padding: 0;
    border: 0;
    background: none;
    text-align: left;
    text-decoration: underline dotted var(--soft);
    text-underline-offset: 0.25em;
  }
  tr[aria-current='true'] > * {
    background: var(--now);
  }
`;
