import { css } from 'lit';

/** The reasons at a pixel: a sentence for each polygon, beside them a column of depths. */
export const whyStyle = css`
  :host {
    display: flex;
    flex: 0 1 auto;
    flex-direction: column;
    max-height: max(55%, 10.5rem);
    font-size: 0.8125rem;
    line-height: 1.4;
  }
  h3 button {
    width: 100%;
    padding: 0.2rem 0.75rem;
    border: 0;
    background: none;
    color: inherit;
    text-align: left;
  }
  h3 button::before {
    content: '▸ ';
  }
  h3 button[aria-expanded='true']::before {
    content: '▾ ';
  }
  #reasons {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: start;
    min-height: 8.5rem;
    padding-bottom: 0.4rem;
    overflow: auto;
    scrollbar-width: thin;
  }
  ul {
    list-style: none;
  }
  p {
    padding: 0.2rem 0.75rem;
    font-weight: 600;
  }
  li button {
    display: grid;
    grid-template-columns: 1.1rem minmax(0, 1fr);
    gap: 0 0.4rem;
    width: 100%;
    min-height: 1.75rem;
    padding: 0.2rem 0.5rem 0.2rem 0.6rem;
    border: 0;
    border-radius: 0;
    background: none;
    text-align: left;
    overflow-wrap: anywhere;
  }
  li button:focus-visible {
    outline-offset: -3px;
  }
  .swatch {
    margin: 0.3em auto 0;
  }
  .shows {
    font-weight: 600;
  }
  .chosen button {
    background: var(--well);
  }
  button[aria-pressed='true'] {
    background: var(--accent-wash);
    box-shadow: inset 3px 0 var(--accent);
  }
  li.pointed {
    background: none;
    box-shadow: inset -3px 0 var(--pointed);
  }
  abbr {
    text-decoration: none;
  }
  .more {
    margin: 0.3rem 0.75rem;
    padding: 0 0.7rem;
    font-size: inherit;
  }
  .column {
    position: sticky;
    top: 0;
    width: 5.5rem;
    height: 8.25rem;
    margin-right: 0.4rem;
    font: 11px var(--mono);
  }
  .column path {
    fill: none;
    stroke: var(--ink);
  }
  .column text {
    fill: var(--ink);
  }
  .column .id {
    font-weight: 600;
  }
  .column .nearer {
    fill: var(--soft);
    font: 10px var(--sans);
  }
  .column :is(.axis, .other, .leader) {
    stroke: var(--soft);
  }
  .column .tick {
    stroke-width: 2.5;
  }
  .column .plane {
    stroke-dasharray: 3 2;
  }
  .column path.gap {
    stroke: var(--accent);
    stroke-width: 3;
  }
  .column text.gap {
    fill: var(--accent);
    font-weight: 600;
  }
  .column .color {
    stroke: var(--soft);
    stroke-width: 1;
  }
  @container (min-width: 1500px) {
    :host {
      font-size: 0.9375rem;
    }
  }
`;
