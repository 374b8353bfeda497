import { css } from 'lit';

/** Its parts are items of the surrounding grid. */
export const comparedStyle = css`
  :host {
    display: contents;
  }
  .name {
    grid-area: name-one;
    display: flex;
    flex-wrap: wrap;
    gap: 0 0.75rem;
    align-items: center;
    align-content: end;
    min-height: 2rem;
    padding-inline: var(--name-inset, 0px);
  }
  .listing {
    grid-area: list-one;
  }
  .picture {
    grid-area: picture-one;
  }
  .sentence {
    grid-area: said-one;
  }
  :host(.other) .name {
    grid-area: name-other;
  }
  :host(.other) .listing {
    grid-area: list-other;
  }
  :host(.other) .picture {
    grid-area: picture-other;
  }
  :host(.other) .sentence {
    grid-area: said-other;
  }
  section {
    display: flex;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  section > * {
    flex: 1;
    min-width: 0;
  }
  .listing {
    display: var(--listing, flex);
    contain: size;
  }
  /* Where there is little room, the step has a line of its own, because its number may grow. */
  h3 {
    flex: 0 1 var(--name-width, auto);
    color: var(--ink);
    font-size: var(--name-size, 0.9375rem);
    letter-spacing: 0;
  }
  .note,
  .step {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .step {
    display: flex;
    gap: 0.25rem;
    margin-left: auto;
  }
  button {
    width: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  input {
    width: 5rem;
    padding: 0 0.3rem;
    color: var(--ink);
    font-family: var(--mono);
  }
  .sentence {
    display: flex;
    gap: 0.6rem;
    align-items: center;
    height: var(--said, 3.1rem);
    padding: 0 0.6rem;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    font-size: var(--said-size, 1rem);
    line-height: 1.35;
  }
  .sentence .at {
    flex: none;
    min-width: 3rem;
    padding: 0.1rem 0.3rem;
    border-radius: 5px;
    background: var(--now);
    font: 600 0.875rem / 1.5 var(--mono);
    text-align: center;
  }
  @media print {
    .listing {
      zoom: 0.7;
    }
  }
`;
