import { css } from 'lit';

export const legendStyle = css`
  :host {
    position: relative;
  }
  button {
    display: grid;
    place-items: center;
    width: 1.5rem;
    min-height: 1.5rem;
    height: 1.5rem;
    padding: 0;
    border-radius: 50%;
    color: var(--soft);
    font:
      italic 600 0.875rem/1 Georgia,
      'DejaVu Serif',
      serif;
  }
  button[aria-expanded='true'] {
    border-color: var(--accent);
    color: var(--accent);
  }
  section {
    position: absolute;
    right: 0;
    bottom: calc(100% + 0.5rem);
    z-index: 3;
    width: min(27rem, calc(100cqw - 2rem));
    padding: 0.75rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    box-shadow: 0 4px 20px rgb(10 12 18 / 30%);
    font-size: 0.8125rem;
    line-height: 1.35;
  }
  h3 {
    margin-bottom: 0.5rem;
    color: var(--ink);
    font-size: 0.875rem;
  }
  ul {
    display: grid;
    gap: 0.3rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 0.6rem;
    align-items: center;
  }
  li.cases {
    display: block;
  }
  .cases ul {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 0.9rem;
    margin-top: 0.3rem;
  }
  canvas {
    width: 28px;
    height: 14px;
    border-radius: 2px;
    background: var(--well);
  }
  p {
    margin-top: 0.6rem;
    color: var(--soft);
  }
`;
