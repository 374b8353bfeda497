import { css } from 'lit';

/** The colours of a strip; they also differ in lightness. */
export const stripColors = css`
  :host {
    --empty: #6b7686;
    --surrounded: #00796b;
    --pixel: #2563d6;
    --single: #bf6500;
    --split: #451a75;
    --level: #5361c4;
  }
  @media (prefers-color-scheme: dark) {
    :host {
      --empty: #8b96a6;
      --surrounded: #35c9b1;
      --pixel: #6ba2ff;
      --single: #f2a444;
      --split: #d0aeff;
      --level: #8391ef;
    }
  }
`;
