import { css } from 'lit';
import { leastPanel } from '../elements/theme.js';

/** For a projector: the content of 850 pixels, as large as the screen allows. */
export const presenterStyle = css`
  :host([presenting]) {
    position: fixed;
    inset: 0;
    z-index: 10;
    padding: 0.5rem 0.5rem 0;
    overflow: auto;
    --gap: 0.5rem;
    background: var(--paper);
    --bar: 0px;
    --hall: grid;
    --hall-values: repeat(2, minmax(0, 1fr));
    --hall-gap: 0.4rem;
    --hall-list: 5rem;
    --hall-line: 0px;
    --hall-wide: auto;
  }
  @media (min-width: 1000px) {
    :host([presenting]) {
      zoom: 1.2;
    }
  }
  @media (min-width: 1200px) {
    :host([presenting]) {
      zoom: 1.5;
    }
  }
  @media (min-width: 1600px) and (min-height: 850px) {
    :host([presenting]) {
      zoom: 1.9;
    }
  }
  @media (min-width: 1900px) and (min-height: 1000px) {
    :host([presenting]) {
      zoom: 2.25;
    }
  }
  @media (min-width: 2500px) and (min-height: 1300px) {
    :host([presenting]) {
      zoom: 3;
    }
  }
  @media (min-width: 3800px) and (min-height: 2000px) {
    :host([presenting]) {
      zoom: 4.5;
    }
  }
  :host([presenting]) .stage {
    --picture-share: 1fr;
    --beside-share: 1.05fr;
    --side-share: 1.2fr;
    min-height: ${leastPanel};
  }
  :host([presenting]) .beside {
    grid-template:
      'listing' minmax(0, 1fr)
      'between' var(--gap)
      'side' minmax(0, var(--side-share)) / minmax(0, 1fr);
  }
  :host([presenting]) .beside:not(:has(> .side)) {
    grid-template: 'listing' minmax(0, 1fr) / minmax(0, 1fr);
  }
  :host([presenting]) .beside:has(> .scene) {
    display: grid;
    grid-template: 'listing' minmax(0, 1fr) 'scene' minmax(0, 1.6fr) / minmax(0, 1fr);
    gap: var(--gap);
  }
  :host([presenting]) .beside:has(> .scene) > .side {
    display: none;
  }
  :host([presenting]) .beside:has(> .solid) {
    --side-share: 1.5fr;
  }
  :host([presenting]) .beside:has(> .side:is(.predict, .exact)) {
    --side-share: 2.4fr;
  }
  :host([presenting]) .dock {
    padding: 0.3rem 0.7rem;
  }
  :host([presenting]) .sentence {
    height: 3.6rem;
    font-size: 1.25rem;
    line-height: 1.3;
  }
  @media (max-width: 520px) {
    :host([presenting]) {
      padding: 0.25rem 0 0;
    }
    :host([presenting]) .sentence {
      height: 5.5rem;
      font-size: 0.875rem;
      line-height: 1.2;
    }
  }
  :host([presenting]) :is(vidno-transport, vidno-divider) {
    display: none;
  }
  .corner {
    display: flex;
    flex: none;
    gap: 0.5rem;
    align-items: center;
    margin-left: auto;
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .corner button {
    width: 1.75rem;
    min-height: 1.75rem;
    padding: 0;
  }
  .curtain {
    position: fixed;
    inset: 0;
    z-index: 11;
    background: #000000;
  }
`;
