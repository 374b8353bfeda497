import { css } from 'lit';

/** A list to choose from beside its name. */
export const selectStyle = css`
  .choice {
    display: flex;
    gap: 0.5rem;
    align-items: center;
    min-width: 0;
  }
  .choice > span {
    color: var(--soft);
  }
  select {
    min-width: 0;
    max-width: 24rem;
    padding: 0 0.5rem;
  }
`;
