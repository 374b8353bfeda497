import { css } from 'lit';

/** The player as a part of another page: with a fixed size, and with few controls or none. */
export const embeddedStyle = css`
  :host([src]) {
    height: 36rem;
  }
  /* The surrounding page determines the size. The content scrolls if it does not fit, and never covers the text around it. */
  :host([src]:not([presenting])) {
    overflow: auto;
  }
  :host(:is([controls='small'], [controls='none'])) {
    --least-picture: 0px;
  }
  :host(:is([controls='small'], [controls='none'])) :is(.side, vidno-divider, vidno-travel) {
    display: none;
  }
  :host([controls='none']) vidno-transport {
    display: none;
  }
  :host(:is([controls='small'], [controls='none'])) .stage {
    flex: 1;
    grid-template:
      'picture beside' minmax(0, 1fr)
      'dock dock' auto / minmax(0, 1fr) minmax(0, 1fr);
    gap: 0 var(--gap);
  }
  :host(:is([controls='small'], [controls='none'])) .beside {
    margin: 0;
    grid-template: 'listing' minmax(0, 1fr) / minmax(0, 1fr);
    contain: size;
  }
  :host(:is([controls='small'], [controls='none'])) .dock {
    position: static;
  }
  @container (max-width: 620px) {
    :host(:is([controls='small'], [controls='none'])) .stage {
      grid-template:
        'picture' minmax(0, 1.6fr)
        'beside' minmax(0, 1fr)
        'dock' auto / minmax(0, 1fr);
      gap: var(--gap) 0;
    }
    :host(:is([controls='small'], [controls='none'])) .dock {
      margin: 0;
    }
  }
`;
