import { css } from 'lit';

/**
 * The least side of a picture's box. With its margins, a square area then has 280 CSS pixels. The page scrolls if there is
 * less room.
 */
export const leastPicture = css`20rem`;

/** The room for the zoom buttons above a picture that fills the width of a phone. */
export const zoomButtons = css`1.4rem`;

/** The least side with a border. */
export const leastPanel = css`calc(20rem + 2px)`;

/** A screen of this height has room for all controls of a lesson below a picture that fills the width of a phone. */
export const tallScreen = css`740px`;

/** The height of the controls that a lower screen leaves out. */
export const moreControls = css`5.2rem`;
