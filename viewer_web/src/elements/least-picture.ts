import { css } from 'lit';

/** No side of a picture's box is less: with the margins around it, a square area has 280 CSS pixels. Rather the page scrolls. */
export const leastPicture = css`20rem`;

/** The same with a line around it. */
export const leastPanel = css`calc(20rem + 2px)`;
