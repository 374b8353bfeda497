import { css } from 'lit';

/** The looks of regions, on the picture in both themes. */
export const regionsStyle = css`
  .shown {
    fill-opacity: 0.55;
    stroke: #10131c;
    stroke-width: 1.25;
    stroke-opacity: 0.7;
  }
  .newly {
    stroke: var(--mark);
    stroke-width: 3;
  }
  .listed {
    stroke: #4b5463;
    stroke-width: 1.25;
    stroke-dasharray: 2 3;
  }
  .facet {
    stroke: #4b5463;
    stroke-width: 1.5;
  }
  .clip-region {
    stroke: #10131c;
    stroke-width: 3.5;
  }
  .casing.clip-region {
    stroke: #ffffff;
    stroke-width: 6;
  }
  .subject {
    stroke: var(--mark);
    stroke-width: 2.5;
    stroke-dasharray: 7 3;
  }
  .casing.subject {
    stroke: #ffffff;
    stroke-width: 5;
    stroke-dasharray: none;
  }
  .inside-part {
    stroke: #005f9e;
    stroke-width: 1.5;
  }
  .outside-part {
    stroke: #9a4a00;
    stroke-width: 1.25;
    stroke-dasharray: 4 3;
  }
  .inside-part.outline,
  .outside-part.outline {
    stroke-width: 2.25;
  }
  .edge-piece {
    stroke: var(--mark);
    stroke-width: 5;
  }
  .piercing-line {
    stroke: #6f2fa8;
    stroke-width: 2;
    stroke-dasharray: 9 3 2 3;
  }
  .enters {
    fill: #005f9e;
    stroke: #ffffff;
    stroke-width: 1.5;
  }
  .leaves {
    fill: #ffffff;
    stroke: #9a4a00;
    stroke-width: 2.25;
  }
`;
