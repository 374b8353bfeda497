import { css } from 'lit';

export const transportStyle = css`
  :host {
    display: grid;
    grid-template-columns: auto minmax(6rem, 1fr) auto auto;
    gap: 0.5rem 1rem;
    align-items: center;
  }
  .buttons {
    display: flex;
    gap: 0.25rem;
  }
  button {
    display: grid;
    place-items: center;
    width: 2.5rem;
    height: 2.5rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  .play {
    width: 3.25rem;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  svg {
    width: 1.25rem;
    height: 1.25rem;
    fill: currentColor;
    stroke: currentColor;
    stroke-width: 1.5;
    stroke-linejoin: round;
  }
  .slider {
    width: 100%;
    min-height: 2rem;
    margin: 0;
    accent-color: var(--accent);
  }
  label {
    display: flex;
    gap: 0.4rem;
    align-items: center;
    color: var(--soft);
    font-size: 0.8125rem;
    white-space: nowrap;
  }
  input[type='number'] {
    width: 6.5rem;
    padding: 0 0.4rem;
    color: var(--ink);
    font-family: var(--mono);
  }
  select {
    padding: 0 0.3rem;
    color: var(--ink);
  }
  @container (max-width: 620px) {
    :host {
      grid-template-columns: minmax(4rem, 1fr) auto auto;
      gap: 0.4rem 0.6rem;
    }
    .buttons {
      grid-column: 1 / -1;
      justify-content: center;
    }
    label > span:first-child {
      position: absolute;
      clip-path: inset(50%);
    }
    input[type='number'] {
      width: 4.6rem;
    }
  }
`;
