import { css } from 'lit';

export const predictStyle = css`
  :host {
    display: block;
    min-height: 0;
    overflow: auto;
    scroll-padding: 2rem 0 3.5rem;
    scrollbar-width: thin;
    font-size: 0.8125rem;
  }
  section {
    padding: 0.6rem 0.75rem;
  }
  section + section {
    border-top: 1px solid var(--line);
  }
  .hint,
  small {
    color: var(--soft);
  }
  small {
    display: block;
    font-size: 0.92em;
  }
  .next {
    margin-top: 0.5rem;
    padding: 0 0.8rem;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  kbd {
    font: 0.6875rem var(--mono);
  }
  fieldset {
    min-width: 0;
    margin: 0.4rem 0 0;
    padding: 0;
    border: 0;
  }
  legend {
    padding: 0;
    font-weight: 600;
  }
  label {
    display: flex;
    gap: 0.45rem;
    align-items: baseline;
    min-height: 1.625rem;
    padding: 0.15rem 0;
    cursor: pointer;
  }
  label input {
    flex: none;
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
    transform: translateY(0.15rem);
  }
  ol {
    margin: 0.3rem 0 0.5rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: 1.1rem minmax(0, 1fr) auto;
    gap: 0.4rem;
  }
  label .number {
    margin-left: auto;
  }
  .number {
    color: var(--soft);
    font-size: 0.75rem;
  }
  .good {
    color: var(--good);
  }
  .bad {
    color: var(--bad);
  }
  .save {
    display: flex;
    flex-wrap: wrap;
    gap: 0.4rem;
  }
  .save input {
    flex: 1;
    min-width: 8rem;
    min-height: 2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--well);
  }
  .save button,
  .moodle button {
    padding: 0 0.8rem;
  }
  @container (min-width: 1500px) {
    :host {
      font-size: 0.9375rem;
    }
  }
  @media print {
    :host {
      overflow: hidden;
    }
    ol {
      columns: 2;
    }
    .choice,
    .next,
    .save button,
    .moodle button {
      display: none;
    }
  }
`;
