import { css } from 'lit';

export const questionStyle = css`
  :host {
    display: block;
  }
  h3 {
    color: var(--ink);
    font-size: 1em;
    letter-spacing: 0;
    overflow-wrap: anywhere;
  }
  h3 + .hint {
    margin-top: 0.4rem;
  }
  h3:focus-visible,
  .result:focus-visible {
    outline-offset: 3px;
    border-radius: 3px;
  }
  fieldset {
    min-width: 0;
    margin: 0.6rem 0 0;
    padding: 0;
    border: 0;
  }
  legend {
    padding: 0;
    font-weight: 600;
  }
  /* The part that the picture answers, and for which there is a hint. */
  .in-hand {
    margin-left: -0.6rem;
    padding-left: calc(0.6rem - 3px);
    border-left: 3px solid var(--accent);
  }
  .good {
    color: var(--good);
  }
  .bad {
    color: var(--bad);
  }
  .options {
    display: flex;
    flex-wrap: wrap;
    gap: 0 1.25rem;
  }
  .options:has(.note) {
    display: block;
  }
  label {
    display: flex;
    gap: 0.4rem;
    align-items: baseline;
    min-height: 1.625rem;
    padding: 0.15rem 0;
    cursor: pointer;
    overflow-wrap: anywhere;
  }
  fieldset:disabled label {
    cursor: default;
  }
  fieldset:disabled label:has(:checked) {
    font-weight: 600;
  }
  /* Where the picture stays in sight, it covers the upper part of the screen. */
  :is(h3, .result, input, button) {
    scroll-margin-top: var(--covered, 0px);
  }
  label input {
    flex: none;
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
    align-self: center;
  }
  kbd {
    color: var(--soft);
    font: 0.6875rem var(--mono);
  }
  .note {
    color: var(--soft);
    font-size: 0.85em;
  }
  .given {
    padding: 0.15rem 0;
    list-style: none;
  }
  input[type='text'] {
    width: 100%;
    min-height: 2rem;
    margin-top: 0.2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--soft);
    border-radius: 6px;
    background: var(--well);
    font-family: var(--mono);
  }
  table {
    margin-top: 0.2rem;
    border-collapse: collapse;
  }
  th,
  td {
    padding: 0.1rem 0.5rem 0.1rem 0;
    font-weight: 400;
    text-align: left;
  }
  td input[type='text'] {
    width: 7em;
    margin-top: 0;
  }
  [aria-invalid='true'] {
    border-color: var(--bad);
    color: var(--bad);
  }
  .hint {
    color: var(--soft);
    font-size: 0.92em;
  }
  .right,
  .first-wrong {
    font-weight: 600;
  }
  /* Nothing moves when the reader turns to another part, or a click could miss. */
  .away {
    visibility: hidden;
  }
  .hinted {
    color: var(--soft);
  }
  .ruled-out span {
    color: var(--soft);
    text-decoration: line-through;
  }
  .entries {
    display: flex;
    flex-wrap: wrap;
    gap: 0.25rem;
    margin-top: 0.25rem;
  }
  .entries button {
    min-width: 2rem;
    min-height: 1.75rem;
    font-family: var(--mono);
  }
  .buttons {
    display: flex;
    flex-wrap: wrap;
    gap: 0.4rem;
    margin-top: 0.7rem;
  }
  .buttons button {
    padding: 0 0.8rem;
  }
  /* In sight however long the question is. */
  .to-do {
    position: sticky;
    bottom: 0;
    margin: 0.4rem 0 -0.6rem;
    padding: 0.3rem 0 0.6rem;
    background: var(--panel);
  }
  .main {
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  .main kbd {
    color: inherit;
  }
  .missing:not(:empty) {
    margin-top: 0.9rem;
    padding: 0.3rem 0.6rem;
    border-radius: 6px;
    background: var(--warn-wash);
    color: var(--warn);
  }
  .result {
    margin-top: 0.7rem;
    padding: 0.35rem 0.6rem;
    border-left: 3px solid currentColor;
    background: var(--well);
    font-weight: 700;
  }
  .result.right {
    color: var(--good);
  }
  .result:is(.wrong, .givenUp) {
    color: var(--bad);
  }
  h4 {
    margin: 0.6rem 0 0.1rem;
    font-size: 0.92em;
    color: var(--soft);
  }
  .reasons {
    margin: 0 -0.75rem;
    list-style: none;
  }
  .reasons button {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 0.5rem;
    width: 100%;
    min-height: 1.75rem;
    padding: 0.15rem 0.75rem;
    border: 0;
    border-radius: 0;
    background: none;
    text-align: left;
    overflow-wrap: anywhere;
  }
  .reasons button:hover {
    background: var(--well);
  }
  .reasons button:focus-visible {
    outline-offset: -3px;
  }
  .reasons .number {
    color: var(--soft);
    font-size: 0.6875rem;
    line-height: 1.65;
  }
  /* Above the time controls, which stay at the bottom there. */
  @container (max-width: 960px) {
    input,
    button,
    .result,
    h3 {
      scroll-margin: 1rem 0 18rem;
    }
  }
  @media print {
    .buttons,
    .missing {
      display: none;
    }
  }
`;
