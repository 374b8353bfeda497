import { css } from 'lit';

export const surfaceFormStyle = css`
  .function {
    display: flex;
    gap: 0.4rem;
    align-items: center;
    font-family: var(--mono);
  }
  .function input {
    flex: 1;
    min-width: 0;
    min-height: 2rem;
    padding: 0 0.4rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    font-family: var(--mono);
    font-size: 0.8125rem;
  }
  .hint {
    margin: 0.2rem 0 0.4rem;
    color: var(--soft);
    font-size: 0.6875rem;
  }
  fieldset {
    min-width: 0;
    margin: 0.5rem 0 0;
    padding: 0;
    border: 0;
  }
  legend {
    padding: 0;
    color: var(--soft);
    font-size: 0.75rem;
    font-weight: 600;
  }
  .by-function {
    margin-top: 0.4rem;
    padding: 0 0.55rem;
  }
`;
