import { css } from 'lit';

export const factsStyle = css`
  :host {
    position: relative;
    display: block;
    flex: none;
    padding: 0.45rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    font-size: 0.8125rem;
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 1.5rem;
    align-items: center;
  }
  .row > p {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 0.6rem;
    align-items: center;
    min-height: 2rem;
  }
  .switches {
    margin-left: auto;
  }
  .name,
  dt,
  .who {
    color: var(--soft);
  }
  button {
    padding: 0 0.6rem;
  }
  label {
    display: flex;
    gap: 0.35rem;
    align-items: center;
    min-height: 1.5rem;
    white-space: nowrap;
  }
  input {
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
  }
  dl {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(8.4rem, 1fr));
    gap: 0.3rem 0.75rem;
    margin-top: 0.3rem;
    padding-top: 0.35rem;
    border-top: 1px solid var(--line);
  }
  .fold {
    display: none;
  }
  .fold::before {
    content: '▸ ';
  }
  .fold[aria-expanded='true']::before {
    content: '▾ ';
  }
  dt,
  .who {
    font-size: 0.75rem;
    line-height: 1.5;
  }
  dt,
  dd {
    white-space: nowrap;
    line-height: 1.5;
  }
  dd small {
    color: var(--soft);
    font-size: 0.75rem;
  }
  label:not(:first-child) {
    margin-left: 0.5rem;
  }
  /* Numbers may grow from step to step; nothing else must move. */
  @container (max-width: 1100px) {
    .row > p {
      flex-basis: 100%;
      margin-left: 0;
    }
  }
  @container (max-width: 620px) {
    label:not(:first-child) {
      margin-left: 0;
    }
    .fold {
      display: block;
      margin-top: 0.3rem;
    }
    .fold:not([aria-expanded='true']) + dl {
      display: none;
    }
  }
  @media print {
    .row > .switches {
      display: none;
    }
    button {
      padding: 0;
      border: 0;
    }
  }
`;
