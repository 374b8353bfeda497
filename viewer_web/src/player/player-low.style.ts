import { css } from 'lit';
import { leastPanel } from '../elements/least-picture.js';

/** The page's own player without a text beside it. */
const alone = css`:host(:not([beside], [presenting], [src], [controls='small'], [controls='none']))`;

/** On a low screen a dock that stays would hide the picture: it is next to it. */
export const playerLowStyle = css`
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  @media (max-height: 599px) and (max-width: 1199px) {
    ${alone} {
      display: grid;
      grid-template:
        'picture side' minmax(min-content, auto)
        'dock dock' auto
        'listing listing' 26rem / minmax(${leastPanel}, 1fr) minmax(0, 1fr);
    }
    ${alone} .panels {
      display: contents;
    }
    ${alone} .picture {
      grid-area: picture;
    }
    ${alone} .side {
      grid-area: side;
    }
    ${alone} .listing {
      grid-area: listing;
    }
    ${alone} .dock {
      grid-area: dock;
    }
  }
  @media (max-height: 599px) and (max-width: 649px) {
    ${alone} .panels > .side {
      contain: none;
    }
    ${alone} {
      grid-template:
        'picture' auto
        'dock' auto
        'side' auto
        'listing' 19rem / minmax(0, 1fr);
    }
  }
`;
