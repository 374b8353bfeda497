import { css } from 'lit';

export const travelStyle = css`
  :host {
    display: flex;
    gap: 0.4rem 1.5rem;
    align-items: center;
    font-size: 0.8125rem;
  }
  .group {
    display: flex;
    gap: 0.25rem;
    align-items: center;
  }
  .name {
    margin-right: 0.25rem;
    color: var(--soft);
    white-space: nowrap;
  }
  button {
    display: grid;
    flex: none;
    place-items: center;
    width: 2.25rem;
    height: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  svg {
    width: 1.25rem;
    height: 1.25rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.75;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .back svg {
    transform: scaleX(-1);
  }
  .goal {
    flex: 1;
    min-width: 0;
  }
  select {
    width: 15rem;
    min-width: 0;
    padding: 0 0.3rem;
    text-overflow: ellipsis;
  }
  .count {
    min-width: 5rem;
    color: var(--soft);
  }
  :host([brief]) :is(.name, .count) {
    display: none;
  }
  :host([brief]) {
    gap: 0.25rem;
  }
  :host([brief]) > button {
    visibility: var(--quiet, visible);
  }
  :host([brief]) select {
    width: 11rem;
  }
  @container (max-width: 920px) {
    :host([brief]) select {
      width: 7rem;
    }
  }
  /* Here every button has a border. */
  @media (forced-colors: active) {
    :host([brief]) select {
      width: 7.5rem;
    }
  }
  @container (max-width: 1100px) {
    :host {
      gap: 1rem;
    }
    .group:not(.goal) .name {
      display: none;
    }
  }
  @container (max-width: 960px) {
    .count {
      display: none;
    }
  }
  @container (max-width: 620px) {
    :host {
      gap: 0.75rem;
    }
    .name {
      display: none;
    }
    select {
      flex: 1;
      width: 0;
    }
    button {
      width: 2rem;
    }
  }
`;
