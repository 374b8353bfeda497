import { css } from 'lit';

/** The numbers of a decision, and the map beside or under them. */
export const exactnessStyle = css`
  dl {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 0.2rem 0.9rem;
    align-content: start;
    min-height: 3.95rem;
  }
  dt,
  dd {
    font-size: 0.8125rem;
    line-height: 1.45;
  }
  dd {
    white-space: normal;
    overflow-wrap: anywhere;
  }
  dd.words {
    font-family: inherit;
  }
  .hint {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .verdict {
    margin-top: 0.5rem;
    padding: 0.3rem 0.5rem;
    border-radius: 5px;
    background: var(--well);
  }
  .verdict.wrong {
    background: var(--bad-wash);
    color: var(--bad);
  }
  .verdict.right {
    color: var(--good);
  }
  button {
    margin-top: 0.5rem;
    padding: 0 0.8rem;
  }
  :host([bare]) {
    flex-direction: row;
  }
  :host([bare]) section {
    flex: 1;
    border: 0;
  }
  :host([bare]) section + section {
    flex: 1.5;
  }
  vidno-lens {
    display: block;
    max-width: 26rem;
    margin-top: 0.4rem;
  }
  :host([bare]) vidno-lens {
    max-width: 9rem;
  }
  @media print {
    :host {
      flex-direction: row;
    }
    section {
      flex: 1;
    }
    section + section {
      border: 0;
    }
    button {
      display: none;
    }
    vidno-lens {
      max-width: 13rem;
    }
  }
  .by-hand h4 {
    margin: 0.5rem 0 0.15rem;
    font-size: 0.75rem;
    font-weight: 600;
    color: var(--soft);
  }
  .lines {
    margin: 0;
    padding: 0;
    list-style: none;
    font-family: var(--mono, ui-monospace, monospace);
    font-size: 0.75rem;
    line-height: 1.5;
    overflow-wrap: anywhere;
  }
`;
