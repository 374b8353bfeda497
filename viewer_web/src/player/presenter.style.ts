import { css } from 'lit';
import { leastPanel } from '../elements/theme.js';

/**
 * For a lecture hall: the picture, beside it the procedure and the state, and below them the sentence, each in its place.
 * `Presenter` enlarges all of it, so type of 0.75rem has at least a fiftieth of the screen's height.
 */
export const presenterStyle = css`
  :host([presenting]) {
    position: fixed;
    inset: 0;
    z-index: 10;
    padding: 0.375rem;
    overflow: auto;
    --gap: 0.375rem;
    background: var(--paper);
    --bar: 0px;
  }
  :host([presenting]) .stage {
    min-height: ${leastPanel};
  }
  :host([presenting]) .side {
    display: flex;
  }
  @media (min-width: 720px) {
    :host([presenting]) .stage {
      grid-template:
        'picture across beside' minmax(min-content, 1fr)
        'dock dock dock' auto / minmax(${leastPanel}, 1fr) var(--gap) minmax(0, 1.3fr);
    }
    /* The state has the height of its parts, which is the same at each step, and the procedure what remains. */
    :host([presenting]) .beside {
      grid-template:
        'listing' minmax(0, 1fr)
        'between' var(--gap)
        'side' auto / minmax(0, 1fr);
    }
    :host([presenting]) .side.state {
      contain: content;
    }
    :host([presenting]) .beside:has(> .side:not(.state)) {
      grid-template-rows: minmax(0, 1fr) var(--gap) minmax(0, var(--side-share));
      --side-share: 1.2fr;
    }
    :host([presenting]) .beside:has(> .solid) {
      --side-share: 1.5fr;
    }
    :host([presenting]) .beside:has(> .side:is(.predict, .exact, .pixel)) {
      --side-share: 2.4fr;
    }
    :host([presenting]) .beside:has(> .scene) {
      display: grid;
      grid-template: 'listing' minmax(0, 1fr) 'scene' minmax(0, 1.6fr) / minmax(0, 1fr);
      gap: var(--gap);
    }
    :host([presenting]) .beside:has(> .scene) > .side {
      display: none;
    }
  }
  :host([presenting]) .dock {
    padding: 0.2rem 0.75rem;
  }
  /* Four lines of the smallest type. */
  :host([presenting]) .sentence {
    height: 3.5rem;
    font-size: 1.125rem;
    line-height: 1.25;
  }
  :host([presenting]) .sentence.long {
    font-size: 0.9375rem;
    line-height: 1.2;
  }
  :host([presenting]) .sentence.longest {
    font-size: 0.75rem;
    line-height: 1.15;
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
    z-index: 12;
    background: #000000;
  }
`;
