import { css } from 'lit';
import { leastPanel, leastPicture } from '../elements/least-picture.js';

/** The pictures are beside each other in the middle, each with its listing on its outer side. */
export const comparisonStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 0.6rem;
    min-height: 0;
    container-type: inline-size;
    --legend: none;
    --least-picture: ${leastPicture};
  }
  /* For a projector everything is magnified, so less is large enough. */
  :host([presenting]) {
    --tools: none;
    --least-picture: 8rem;
  }
  .runs {
    display: grid;
    flex: 1 0 auto;
    gap: 0.5rem 0.6rem;
    grid-template:
      'name-one name-one name-other name-other' auto
      'list-one picture-one picture-other list-other' minmax(min-content, var(--panels, 1fr))
      'said-one said-one said-other said-other' auto
      'facts facts facts facts' auto
      / minmax(0, 1fr) minmax(${leastPanel}, 1fr) minmax(${leastPanel}, 1fr) minmax(0, 1fr);
  }
  vidno-comparison-facts {
    grid-area: facts;
  }
  /* Where there is little room, the pictures and sentences are more important. */
  @media (max-height: 799px) {
    vidno-broken-line {
      --what: none;
      --changes: none;
    }
  }
  /* Where the page scrolls, the time controls stay in sight. */
  .dock {
    position: sticky;
    bottom: 0;
    z-index: 1;
    flex: none;
    padding: 0.5rem 0.9rem 0.6rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  @container (min-width: 1500px) {
    .runs {
      --said: 3.6rem;
      --said-size: 1.1875rem;
    }
  }
  @container (max-width: 1100px) {
    .runs {
      gap: 0.4rem 0.6rem;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' minmax(${leastPanel}, var(--panels, 1fr))
        'said-one said-other' auto
        'list-one list-other' clamp(6.5rem, 100dvh - 41.5rem, 24rem)
        'facts facts' auto
        / minmax(0, 1fr) minmax(0, 1fr);
    }
  }
  @container (max-width: 960px) {
    .runs {
      --name-width: 100%;
      --said: 5.2rem;
      --said-size: 0.9375rem;
      flex: none;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' max(${leastPanel}, 50cqw)
        'said-one said-other' auto
        'facts facts' auto
        'list-one list-other' 24rem
        / minmax(0, 1fr) minmax(0, 1fr);
    }
  }
  /* Two pictures beside each other do not fit. */
  @container (max-width: 650px) {
    .runs {
      --name-width: auto;
      --name-size: 0.8125rem;
      --said: 3.9rem;
      --said-size: 0.875rem;
      gap: 0.4rem;
      grid-template:
        'name-one' auto
        'picture-one' ${leastPanel}
        'said-one' auto
        'name-other' auto
        'picture-other' ${leastPanel}
        'said-other' auto
        'facts' auto
        'list-one' 15rem
        'list-other' 15rem
        / minmax(0, 1fr);
    }
    .dock {
      padding: 0.4rem 0.6rem;
    }
    vidno-broken-line {
      --changes: none;
    }
  }
  :host([presenting]) vidno-broken-line {
    --what: none;
    --changes: none;
    --ways: none;
  }
  :host([presenting]) .runs {
    --listing: none;
    --name-width: 100%;
    --name-size: 0.8125rem;
    --said: 5.4rem;
    --said-size: 1.0625rem;
    flex: 1;
    min-height: 0;
    grid-template:
      'name-one name-other' auto
      'picture-one picture-other' minmax(0, 1fr)
      'said-one said-other' auto
      / minmax(0, 1fr) minmax(0, 1fr);
  }
  :host([presenting]) :is(vidno-comparison-facts, vidno-transport) {
    display: none;
  }
  :host([presenting]) .dock {
    display: flex;
    padding: 0 0 0.3rem;
    border: 0;
    background: none;
  }
  /* A sticky dock would hide the pictures. */
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  /* One sheet, A4. */
  @media print {
    :host {
      container-type: normal;
      --tools: none;
    }
    .runs {
      --said: 20mm;
      flex: 1;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' 88mm
        'said-one said-other' auto
        'facts facts' auto
        'list-one list-other' minmax(0, 1fr)
        / minmax(0, 1fr) minmax(0, 1fr);
    }
    .dock {
      display: none;
    }
  }
`;
