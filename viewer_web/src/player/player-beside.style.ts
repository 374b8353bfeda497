import { css } from 'lit';
import { leastPanel } from '../elements/least-picture.js';

/** Beside the text of a lesson there is less room: the picture, what does not fit is scrolled to. */
export const playerBesideStyle = css`
  @media (max-width: 1699px) {
    :host([beside]) {
      --signs: none;
    }
  }
  @media (min-width: 900px) {
    @container (max-width: 960px) {
      :host([beside]) .panels {
        flex: 1 0 auto;
        grid-template:
          'picture side' minmax(var(--least-side, 9rem), var(--side-share, 1fr))
          'picture listing' minmax(7rem, var(--listing-share, 1fr)) / minmax(${leastPanel}, 1fr)
          minmax(0, 18.5rem);
      }
      :host([beside]) .panels:has(> .side:not(.state)) {
        --side-share: 2fr;
      }
      :host([beside]) .panels:has(> .side.solid) {
        --side-share: 1fr;
        --listing-share: 7rem;
        --least-side: 22rem;
        --caption: 4.4em;
      }
      :host([beside]) .panels > section {
        order: 0;
        height: auto;
        min-height: 0;
      }
      :host([beside]) .panels > :is(.listing, .side) {
        contain: size;
      }
      :host([beside]) .panels .picture {
        grid-area: picture;
      }
      :host([beside]) .panels .side {
        grid-area: side;
      }
      :host([beside]) .panels .listing {
        grid-area: listing;
      }
    }
  }
  @media (min-width: 900px) and (max-height: 860px) {
    :host([beside]) vidno-travel {
      display: none;
    }
    :host([beside]) .sentence {
      height: 3.2rem;
      font-size: 0.875rem;
      line-height: 1.2;
    }
  }
  /* Above the text: one sees the picture, where there is room the listing, and the sentence. */
  @media (max-width: 899px) {
    :host([beside]) {
      --legend: none;
      --strip: none;
      flex: none;
    }
    :host([beside]) vidno-travel {
      display: none;
    }
    :host([beside]) .panels {
      grid-template:
        max(${leastPanel}, 45dvh - 10.75rem) 20rem / minmax(${leastPanel}, 1.1fr)
        minmax(0, 1fr);
    }
    :host([beside]) .panels > section {
      order: 0;
      height: auto;
      min-height: 0;
    }
    :host([beside]) .panels .listing {
      grid-row: 1;
      grid-column: 2;
    }
    :host([beside]) .panels .side {
      grid-row: 2;
      grid-column: 1 / -1;
    }
    :host([beside]) .dock {
      gap: 0.25rem;
      padding-block: 0.25rem;
    }
    :host([beside]) .sentence {
      height: 3.1rem;
      font-size: 0.8125rem;
      line-height: 1.25;
    }
  }
  @media (max-width: 640px) {
    :host([beside]) {
      gap: 0.4rem;
    }
    :host([beside]) .panels {
      grid-template: max(${leastPanel}, 45dvh - 10.75rem) 16rem 20rem / minmax(0, 1fr);
    }
    :host([beside]) .panels > section {
      border-radius: 0;
      border-inline: 0;
    }
    :host([beside]) .panels .listing {
      grid-row: 2;
      grid-column: 1;
    }
    :host([beside]) .panels .side {
      grid-row: 3;
    }
    :host([beside]) .dock {
      border-radius: 0;
      border-inline: 0;
    }
  }
  /* A question is below the picture that it is about, as long as it is; the page scrolls. */
  @media (max-width: 899px) {
    :host([beside][asking]) .panels > .side {
      contain: none;
    }
    :host([beside][asking]) .panels {
      grid-template-rows: max(${leastPanel}, 45dvh - 10.75rem) auto;
    }
  }
  @media (max-width: 640px) {
    :host([beside][asking]) .panels > .side {
      grid-row: 2;
    }
    :host([beside][asking]) .panels > .listing {
      grid-row: 3;
      height: 16rem;
    }
  }
  /* A phone held sideways, or a page enlarged: one column, with the dock next to the picture. */
  @media (max-width: 899px) and (max-height: 599px) {
    :host([beside]) .panels {
      display: contents;
    }
    :host([beside]) .panels > section {
      flex: none;
      height: 16rem;
    }
    :host([beside]) .panels > .picture {
      order: -2;
      height: ${leastPanel};
    }
    :host([beside]) .dock {
      order: -1;
    }
  }
`;
