import { css } from 'lit';

/** A dialog over the page. */
export const dialogStyle = css`
  dialog {
    max-width: min(54rem, calc(100vw - 2rem));
    padding: 1.25rem 1.5rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    color: var(--ink);
  }
  dialog::backdrop {
    background: rgb(10 12 18 / 45%);
  }
  /* It has the focus at first, but cannot be pressed. */
  h2:focus {
    outline: none;
  }
  h2 {
    margin-bottom: 0.75rem;
    font-size: 1rem;
    color: var(--ink);
  }
`;
