import { css } from 'lit';

export const galleryStyle = css`
  :host {
    display: contents;
  }
  dialog {
    width: min(72rem, calc(100vw - 2rem));
    max-width: none;
    height: calc(100dvh - 3rem);
    padding: 0;
    overflow: hidden;
  }
  dialog[open] {
    display: flex;
    flex-direction: column;
  }
  .head {
    display: flex;
    flex: none;
    flex-wrap: wrap;
    gap: 0.5rem 1rem;
    align-items: center;
    padding: 0.75rem 1rem;
    border-bottom: 1px solid var(--line);
  }
  h2 {
    flex: 1;
    margin: 0;
    white-space: nowrap;
  }
  label {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  select {
    max-width: 100%;
    margin-left: 0.3rem;
  }
  .close {
    padding: 0 0.8rem;
  }
  ul {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(13rem, 100%), 1fr));
    gap: 0.75rem;
    margin: 0;
    padding: 1rem;
    overflow: auto;
    list-style: none;
  }
  .entry {
    display: flex;
    flex-direction: column;
    gap: 0.2rem;
    width: 100%;
    height: 100%;
    padding: 0.6rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: none;
    color: inherit;
    font: inherit;
    text-align: left;
    white-space: normal;
  }
  button.entry:hover {
    border-color: var(--accent);
    background: var(--accent-wash);
  }
  .picture {
    display: flex;
    align-items: center;
    justify-content: center;
    height: 8rem;
    margin-bottom: 0.3rem;
    border-radius: 4px;
    background: var(--paper);
    color: var(--soft);
    font-size: 0.75rem;
  }
  svg {
    width: 100%;
    height: 100%;
  }
  path {
    fill: none;
    vector-effect: non-scaling-stroke;
  }
  .patch {
    shape-rendering: crispedges;
  }
  .outline {
    stroke-width: 1.5;
    stroke-opacity: 0.8;
  }
  .line {
    stroke: var(--ink);
    stroke-width: 1.5;
  }
  .wrong {
    stroke: var(--bad);
    stroke-width: 3;
  }
  strong {
    font-size: 0.875rem;
    font-weight: 600;
  }
  small {
    color: var(--soft);
    font-size: 0.75rem;
  }
  .why {
    display: -webkit-box;
    overflow: hidden;
    color: var(--soft);
    font-size: 0.75rem;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 2;
  }
`;
