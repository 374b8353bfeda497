import { css } from 'lit';
import { leastPanel } from './least-picture.js';

/** On a low screen a dock that stays would hide the picture: it is next to it. */
export const playerLowStyle = css`
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  @media (max-height: 599px) and (max-width: 1199px) {
    :host(:not([beside], [presenting], [src], [controls='small'], [controls='none'])) {
      display: grid;
      grid-template:
        'picture side' minmax(min-content, auto)
        'dock dock' auto
        'listing listing' 26rem / minmax(${leastPanel}, 1fr) minmax(0, 1fr);
    }
    :host(:not([beside], [presenting], [src], [controls='small'], [controls='none'])) .panels {
      display: contents;
    }
    .picture {
      grid-area: picture;
    }
    .side {
      grid-area: side;
    }
    .listing {
      grid-area: listing;
    }
    .dock {
      grid-area: dock;
    }
  }
  @media (max-height: 599px) and (max-width: 649px) {
    .panels > .side {
      contain: none;
    }
    :host(:not([beside], [presenting], [src], [controls='small'], [controls='none'])) {
      grid-template:
        'picture' auto
        'dock' auto
        'side' auto
        'listing' 19rem / minmax(0, 1fr);
    }
  }
`;
