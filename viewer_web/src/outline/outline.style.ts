import { css } from 'lit';

/** A search, and below it the scrolling tree. All rows have the same height, so the element can compute their positions. */
export const outlineStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    contain: strict;
  }
  .hint {
    flex: none;
    padding: 0.5rem 0.75rem;
    color: var(--soft);
  }
  .example {
    color: var(--soft);
  }
  .search {
    display: grid;
    flex: none;
    grid-template-columns: minmax(0, 1fr) auto auto;
    gap: 0.35rem;
    align-items: center;
    padding: 0.5rem 0.6rem;
    border-bottom: 1px solid var(--line);
  }
  input {
    width: 100%;
    min-width: 0;
    min-height: 2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    color: var(--ink);
    font: inherit;
    font-size: 0.8125rem;
  }
  .search button {
    display: grid;
    place-items: center;
    width: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    opacity: 0.55;
  }
  svg {
    width: 1rem;
    height: 1rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 2;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .found {
    display: flex;
    grid-column: 1 / -1;
    flex-wrap: wrap;
    gap: 0.25rem 0.35rem;
    align-items: center;
    min-height: 1.5rem;
    font-size: 0.75rem;
  }
  .found [role='status'] {
    margin-left: auto;
    color: var(--soft);
    font-variant-numeric: tabular-nums;
  }
  .search .chip {
    display: flex;
    gap: 0.35rem;
    width: auto;
    min-height: 1.5rem;
    padding: 0 0.5rem;
    border-radius: 0.75rem;
    background: var(--accent-wash);
    font-size: 0.75rem;
    overflow-wrap: anywhere;
  }
  .search .chip.unknown {
    border-color: var(--bad);
    background: var(--bad-wash);
    color: var(--bad);
  }
  .tree {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  .tree:focus-visible {
    outline-offset: -3px;
  }
  .rows {
    position: relative;
    overflow: hidden;
  }
  .row {
    position: absolute;
    inset: 0 0 auto;
    display: flex;
    gap: 0.3rem;
    align-items: center;
    height: var(--row);
    padding: 0 0.6rem 0 calc(0.3rem + min(var(--depth), 12) * 0.7rem);
    font-size: 0.8125rem;
    line-height: 1.2;
    white-space: nowrap;
    cursor: pointer;
    contain: strict;
  }
  .row:hover {
    background: var(--well);
  }
  .fold {
    flex: none;
    display: grid;
    place-items: center;
    width: 1.1rem;
    height: 100%;
    color: var(--soft);
  }
  .fold svg {
    width: 0.75rem;
    height: 0.75rem;
  }
  [aria-expanded='true'] > .fold svg {
    transform: rotate(90deg);
  }
  .said {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .step {
    flex: none;
    color: var(--soft);
    font-size: 0.6875rem;
  }
  .hit .said {
    font-weight: 600;
    text-decoration: underline 2px var(--accent);
    text-underline-offset: 0.2em;
  }
  .now,
  .now:hover {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .now .step,
  .now .fold {
    color: inherit;
  }
  .tree:focus-visible .focused {
    outline: 2px solid var(--accent);
    outline-offset: -2px;
  }
  @media (forced-colors: active) {
    .now {
      outline: 3px solid Highlight;
      outline-offset: -3px;
    }
  }
`;
