import { css } from 'lit';

/** A layer over the picture. Only its parts take the pointer; the rest lets it through. */
export const overlayStyle = css`
  :host {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  svg {
    width: var(--across, 100%);
    height: var(--down, 100%);
    overflow: hidden;
  }
`;
