import { css, unsafeCSS } from 'lit';
import { stateParts } from '../algorithm/shows.js';
import { mostInHall, mostPrinted } from './lists.js';

/** On paper a list states the number of further rows. */
const panelsPrint = css`
  .on-paper {
    display: none;
  }
  @media print {
    :host,
    .list {
      overflow: hidden;
    }
    .counted tr:nth-child(n + ${mostPrinted + 1}),
    .on-screen {
      display: none;
    }
    .on-paper {
      display: block;
    }
    .stack {
      min-height: 0;
    }
    .apl {
      height: auto;
    }
  }
`;

/** The panels of state: tables whose size does not change from step to step. */
const onScreen = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  section {
    flex: none;
    padding: 0.6rem 0.75rem;
  }
  section + section {
    border-top: 1px solid var(--line);
  }
  h3 {
    margin-bottom: 0.35rem;
  }
  .values {
    display: grid;
    --values: minmax(0, 1.2fr) minmax(0, 1.1fr) minmax(0, 1fr);
    grid-template-columns: var(--values);
    gap: 0.35rem 0.75rem;
  }
  .values div {
    min-width: 0;
  }
  .values .wide {
    grid-column: 1 / -1;
  }
  dt {
    overflow: hidden;
    font-size: 0.75rem;
    line-height: 1.3;
    color: var(--soft);
    white-space: nowrap;
    text-overflow: ellipsis;
  }
  dd {
    width: fit-content;
    min-height: 1.45em;
    padding: 0 0.2em;
    margin-left: -0.2em;
    border-radius: 3px;
    font-family: var(--mono);
    white-space: nowrap;
  }
  .changed {
    background: var(--changed);
    --soft: var(--ink); /* which would be too faint here in the dark */
  }
  .corners {
    width: 100%;
    table-layout: fixed;
    border: 1px solid var(--line);
  }
  .corners td {
    height: 2.6rem;
    padding: 0.2rem 0.5rem;
    border: 1px solid var(--line);
    font-family: var(--mono);
    line-height: 1.25;
  }
  .corners small {
    display: block;
    overflow: hidden;
    font: 0.6875rem / 1.3 var(--sans);
    color: var(--soft);
    white-space: nowrap;
    text-overflow: ellipsis;
  }
  .corners i {
    float: right;
    color: var(--soft);
    font-size: 0.75rem;
    font-style: normal;
  }
  .list {
    display: block;
    overflow: auto;
    scrollbar-width: thin;
  }
  .apl {
    height: 6.4rem;
  }
  .apl td:first-child {
    max-width: 14em;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .lists {
    display: grid;
    grid-template-columns: minmax(0, 0.85fr) minmax(0, 1.5fr) minmax(0, 0.85fr);
    gap: 0 0.6rem;
  }
  h4 {
    margin: 0 0 0.2rem;
    font-size: 0.6875rem;
    color: var(--soft);
    white-space: nowrap;
  }
  .rows td.level {
    color: var(--soft);
    font-size: 0.75rem;
    text-align: right;
  }
  .stack {
    min-height: 8rem;
    flex: 1 0 auto;
  }
  .ael {
    height: 6.6rem;
  }
  .ael table {
    table-layout: fixed;
  }
  .ael th:first-child {
    width: 2.3rem;
  }
  .ael th:nth-child(4) {
    width: 1.7rem;
  }

  .rows {
    width: 100%;
  }
  .rows th,
  .rows td {
    height: 1.6rem;
    padding: 0 0.4rem 0 0;
    text-align: left;
    font-weight: 400;
    white-space: nowrap;
  }
  .rows thead th {
    font: 0.75rem / 1.3 var(--sans);
    color: var(--soft);
  }
  .rows td.number {
    font-size: 0.8125rem;
  }
  .ael .rows :is(td, th) {
    padding-right: 0.2rem;
  }
  .ael .rows :is(th, td.number) {
    font-size: 0.6875rem;
  }
  .rows tr.current td {
    font-weight: 600;
  }
  .windows {
    table-layout: fixed;
  }
  .windows td:first-child {
    width: 9.6em;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .windows td:nth-child(2) {
    width: 2.4rem;
    color: var(--soft);
  }
  .pointed .pointed {
    background: none;
    box-shadow: none;
  }
  .pointed td {
    color: var(--ink);
  }
  .chips {
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .chip {
    margin-right: 0.5em;
    white-space: nowrap;
  }
  @container (min-width: 1500px) {
    dt,
    h3,
    .rows thead th,
    .corners small {
      font-size: 0.8125rem;
    }
    dd,
    .corners td,
    .rows td,
    .rows td.number {
      font-size: 1rem;
    }
    .rows th,
    .rows td {
      height: 1.9rem;
    }
    .ael .rows td.number {
      font-size: 0.875rem;
    }
  }
  @container (max-width: 960px) {
    .stack {
      flex: none;
      height: 14rem;
      overflow: auto;
    }
  }
  .empty {
    color: var(--soft);
  }
`;

/** In a lecture hall each part has its place, whatever the step, and no type is smaller than 0.75rem. */
const inHall = css`
  :host([hall]) {
    gap: 0.35rem 0.75rem;
    padding: 0.35rem 0.75rem 0.45rem;
    overflow: hidden;
    --row: 1.2rem;
  }
  :host([hall]) section {
    min-width: 0;
    padding: 0;
    border: 0;
  }
  :host([hall]) :is(h3, h4) {
    margin: 0;
    font-size: 0.75rem;
    line-height: 1.3;
  }
  :host([hall]) .values {
    grid-template-columns: repeat(4, minmax(0, 1fr));
    gap: 0.1rem 0.6rem;
  }
  :host([hall]) dt {
    font-size: 0.75rem;
  }
  :host([hall]) :is(dd, .corners td) {
    font-size: 0.9375rem;
  }
  :host([hall]) dd {
    height: 1.3em;
    min-height: 0;
    line-height: 1.3;
  }
  :host([hall]) .rows :is(th, td) {
    height: var(--row);
    line-height: 1.2;
  }
  :host([hall]) .rows :is(th, td, td.number) {
    font-size: 0.8125rem;
    white-space: nowrap;
  }
  :host([hall]) .rows :is(td.level, td.said, thead th) {
    font-size: 0.75rem;
  }
  :host([hall]) .list {
    height: calc((${mostInHall} + var(--heads, 0)) * var(--row) + 0.2rem);
    overflow: hidden;
  }
  :host([hall]) .empty {
    font-size: 0.75rem;
    line-height: var(--row);
  }
  /* A label and its value in one line. */
  :host([hall]) .line,
  :host([hall]) .line :is(dl, div) {
    display: flex;
    gap: 0.6rem;
    align-items: baseline;
  }
`;

/** A panel reduced to some of its parts hides the others, and those that the trace does not record. */
const onlyParts = unsafeCSS(
  [
    ...stateParts.map((part) => `:host([parts]:not([parts~='${part}'])) [data-part='${part}']`),
    ':host([parts]) .untold',
  ].join(',\n') + ' { display: none; }',
);

export const panelsStyle = [onScreen, inHall, onlyParts, panelsPrint];
