import { css } from 'lit';

/**
 * Marks must be visible on any colours of the picture. Each has a light casing, so that it shows on light and dark, alike
 * in both themes.
 */
export const marksStyle = css`
  :host {
    --mark: #c2006b;
    --chosen: #5a1fc4;
  }
  svg * {
    vector-effect: non-scaling-stroke;
    fill: none;
    stroke-linejoin: round;
    stroke-linecap: round;
  }
  .casing {
    stroke: #ffffff;
    stroke-width: 5;
    stroke-opacity: 0.85;
  }
  .tree,
  .way {
    stroke-linecap: square; /* the corners of boxes, which are drawn as lines */
  }
  .tree {
    stroke: #10131c;
    stroke-width: 1;
    stroke-opacity: 0.55;
  }
  .casing.tree {
    stroke: #ffffff;
    stroke-width: 2;
    stroke-opacity: 0.3;
  }
  .way {
    stroke: #10131c;
    stroke-width: 1.75;
    stroke-opacity: 0.75;
  }
  .stacked {
    stroke: #10131c;
    stroke-width: 1;
    stroke-dasharray: 1.5 4;
    stroke-opacity: 0.8;
    fill: #10131c;
    fill-opacity: 0.07;
  }
  .window {
    stroke: #10131c;
    stroke-width: 3;
  }
  .active {
    stroke-width: 2.5;
  }
  .fresh {
    stroke: var(--mark);
    stroke-width: 2;
    stroke-dasharray: 5 4;
  }
  .off {
    stroke: #5a6372;
    stroke-width: 2;
    stroke-dasharray: 2 4;
  }
  .touched {
    stroke: var(--mark);
    stroke-width: 2.5;
  }
  .scanline {
    stroke: #10131c;
    stroke-width: 1;
    fill: #10131c;
    fill-opacity: 0.08;
  }
  .edge,
  .clip {
    stroke: #10131c;
    stroke-width: 2.5;
  }
  .clip {
    stroke-dasharray: 6 4;
  }
  .clip-new,
  .side {
    stroke: var(--mark);
    stroke-width: 3;
  }
  .casing.way,
  .casing.stacked,
  .casing.scanline {
    stroke-width: 3;
    stroke-opacity: 0.35;
    stroke-dasharray: none;
    fill: none;
  }
  .casing.fresh,
  .casing.off,
  .casing.touched,
  .casing.side,
  .casing.clip,
  .casing.clip-new,
  .casing.window,
  .casing.edge,
  .casing.reach,
  .casing.wrong {
    stroke: #ffffff;
    stroke-width: 5;
    stroke-dasharray: none;
  }
  .casing.wrong {
    fill: none;
  }
  .reach {
    stroke: #10131c;
    stroke-width: 2.5;
    stroke-linecap: butt;
  }
  .chosen,
  .cursor {
    stroke: var(--chosen);
    stroke-width: 2.5;
    stroke-linecap: butt;
  }
  .cursor {
    stroke-width: 1.5;
  }
  .casing.chosen,
  .casing.cursor {
    stroke: #ffffff;
    stroke-width: 5.5;
    stroke-dasharray: none;
    stroke-opacity: 1;
  }
  .casing.active {
    stroke: #10131c;
    stroke-width: 5;
    stroke-opacity: 1;
  }
  .pointed {
    stroke: #10131c;
    stroke-width: 2.5;
  }
  .casing.pointed {
    stroke: var(--pointed);
    stroke-width: 10;
    stroke-opacity: 1;
  }
  .dot {
    stroke: #ffffff;
    stroke-width: 2;
    fill: #10131c;
  }
  .dot.yes,
  .dot.clip-new,
  .dot.point {
    fill: var(--mark);
    stroke: #ffffff;
    stroke-width: 2;
  }
  .dot.pointed {
    fill: #10131c;
    stroke: var(--pointed);
    stroke-width: 5;
  }
  .dot.wrong {
    fill: #c1121f;
    fill-opacity: 1;
    stroke: #ffffff;
    stroke-width: 2;
  }
  .dot.no {
    fill: #ffffff;
    stroke: #10131c;
    stroke-width: 2.5;
  }
  .wrong {
    stroke: #c1121f;
    stroke-width: 2.5;
    fill: #c1121f;
    fill-opacity: 0.2;
  }
  .zero {
    stroke: #0b7a4b;
    stroke-width: 1;
  }
  .narrow {
    stroke: #b25e00;
    stroke-width: 1.5;
    stroke-dasharray: 2 3;
  }
  .margin {
    stroke: #5a1fc4;
    stroke-width: 1.5;
    fill: #5a1fc4;
    fill-opacity: 0.14;
  }
`;
