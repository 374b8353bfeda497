import { css } from 'lit';
import { tallScreen } from '../elements/least-picture.js';

export const transportStyle = css`
  :host {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto auto;
    gap: 0.6rem 1rem;
    align-items: center;
  }
  vidno-slider {
    grid-column: 2 / -1;
  }
  slot {
    display: block;
    grid-column: 1 / 3;
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
    display: flex;
    gap: 0.4rem;
    justify-content: center;
    width: auto;
    min-width: 3.25rem;
    padding: 0 0.5rem;
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
  label {
    display: flex;
    gap: 0.4rem;
    align-items: center;
    color: var(--soft);
    font-size: 0.8125rem;
    white-space: nowrap;
  }
  input[type='number'] {
    width: 5.75rem;
    height: 2rem;
    contain: strict;
    padding: 0 0.4rem;
    color: var(--ink);
    font-family: var(--mono);
  }
  select {
    padding: 0 0.3rem;
    color: var(--ink);
  }
  .words {
    font-weight: 600;
    white-space: nowrap;
  }
  :host([brief]) {
    grid-template-columns: auto minmax(6rem, 1fr) auto auto;
  }
  :host([brief]) .play {
    padding: 0 0.9rem 0 0.7rem;
  }
  :host([brief]) :is(vidno-slider, slot) {
    grid-column: auto;
  }
  @container (max-width: 920px) {
    :host([brief]) {
      gap: 0.5rem;
    }
    :host([brief]) .step > span:first-child {
      position: absolute;
      clip-path: inset(50%);
    }
  }
  @container (max-width: 830px) {
    :host([brief]) .words {
      position: absolute;
      clip-path: inset(50%);
    }
  }
  @container (max-width: 620px) {
    :host([brief]) slot {
      display: none;
    }
    @media (min-height: ${tallScreen}) {
      :host([brief]) slot {
        display: var(--more-controls, block);
        grid-area: 2 / 1 / auto / -1;
      }
    }
  }
  @container (max-width: 800px) {
    :host(:not([brief])) {
      grid-template-columns: 1fr auto auto;
      gap: 0.4rem 0.75rem;
    }
    :host(:not([brief])) vidno-slider {
      grid-row: 2;
      grid-column: 1 / -1;
    }
    :host(:not([brief])) slot {
      grid-row: 3;
      grid-column: 1 / -1;
    }
  }
  @container (max-width: 620px) {
    :host {
      gap: 0.4rem 0.5rem;
    }
    .buttons {
      gap: 0.15rem;
    }
    button {
      width: 2rem;
    }
    .play {
      min-width: 2.5rem;
    }
    label > span {
      position: absolute;
      clip-path: inset(50%);
    }
    input[type='number'] {
      width: 4.4rem;
    }
  }
  @container (max-width: 350px) {
    button {
      width: 1.75rem;
    }
    .play {
      min-width: 2.25rem;
    }
    input[type='number'] {
      width: 3.5rem;
      padding: 0 0.25rem;
    }
    select {
      padding: 0;
    }
  }
`;
