import { css } from 'lit';

/** As a part of another page: of a size of its own, and with few controls or none. */
export const embeddedStyle = css`
  :host([src]) {
    height: 36rem;
  }
  /* Its size is its page's affair: what does not fit is scrolled to, and never over the text around it. */
  :host([src]:not([presenting])) {
    overflow: auto;
  }
  :host(:is([controls='small'], [controls='none'])) {
    --least-picture: 0px;
  }
  :host(:is([controls='small'], [controls='none'])) :is(.side, vidno-travel) {
    display: none;
  }
  :host([controls='none']) vidno-transport {
    display: none;
  }
  :host(:is([controls='small'], [controls='none'])) .panels {
    flex: 1;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr) minmax(0, 1fr);
  }
  :host(:is([controls='small'], [controls='none'])) .panels > section {
    grid-area: auto;
    height: auto;
  }
  :host(:is([controls='small'], [controls='none'])) .dock {
    position: static;
  }
  @container (max-width: 620px) {
    :host(:is([controls='small'], [controls='none'])) .panels {
      grid-template: minmax(0, 1.6fr) minmax(0, 1fr) / minmax(0, 1fr);
    }
  }
`;
