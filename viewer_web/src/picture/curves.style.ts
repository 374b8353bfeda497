import { css } from 'lit';

/**
 * The looks of the picture of curves, on white in both themes. The horizons lie under the lines that are on them. The lower
 * one is narrower, for places where both coincide.
 */
export const curvesStyle = css`
  .visible {
    stroke: #10131c;
    stroke-width: 1.75;
  }
  .rival {
    stroke: var(--mark);
    stroke-width: 1.25;
  }
  .current {
    stroke: #8a93a3;
    stroke-width: 1.5;
  }
  .samples {
    stroke: #8a93a3;
    stroke-width: 1;
    fill: #ffffff;
  }
  .segment {
    stroke: #4b5463;
    stroke-width: 3;
  }
  .upper {
    stroke: #56b4e9;
    stroke-width: 5;
  }
  .lower {
    stroke: #f0a060;
    stroke-width: 3;
  }
  .before {
    stroke-width: 1.5;
    stroke-opacity: 0.75;
    stroke-dasharray: 5 3;
  }
  .side-edge {
    stroke: #6f5aa8;
    stroke-width: 1.75;
    stroke-dasharray: 4 2 1 2;
  }
  .looked-at {
    stroke: #4b5463;
    stroke-width: 1;
    stroke-dasharray: 2 3;
  }
  .flag {
    stroke: #ffffff;
    stroke-width: 0.75;
    fill: #10131c;
  }
  .flag.above {
    fill: #0072b2;
  }
  .flag.below {
    fill: #b34a00;
  }
  .flag.hidden {
    stroke: #4b5463;
    stroke-width: 1.25;
    fill: #ffffff;
  }
  .changed-part {
    stroke: var(--mark);
    stroke-width: 3;
  }
  .pointed-curve {
    stroke: var(--pointed);
    stroke-width: 6;
    stroke-opacity: 0.7;
  }
  .pointed-column {
    stroke: var(--pointed);
    stroke-width: 4;
    stroke-opacity: 0.7;
  }
  .chosen-column {
    stroke: var(--chosen);
    stroke-width: 2;
  }
`;
