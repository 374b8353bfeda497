import { css } from 'lit';

/** Grid, outlines and names, which do not change from step to step. */
export const pictureStyle = css`
  :host {
    display: block;
    position: relative;
    contain: strict;
    background: var(--well);
  }
  canvas,
  svg {
    position: absolute;
    inset: 0;
  }
  svg {
    width: var(--across, 100%);
    height: var(--down, 100%);
    cursor: crosshair;
    touch-action: pan-x pan-y;
  }
  .zoomed {
    touch-action: none;
  }
  .zoomed:active {
    cursor: grabbing;
  }
  svg:focus-visible {
    outline-offset: -4px;
  }
  .grid {
    stroke: #7c8798;
    stroke-opacity: 0.28;
    stroke-width: 1;
  }
  .area {
    stroke: #7c8798;
    stroke-width: 1;
  }
  .outline-casing {
    stroke: #ffffff;
    stroke-opacity: 0.8;
    stroke-width: 3;
  }
  .outline {
    stroke-width: 1.5;
  }
  .outline.many {
    stroke-width: 1;
    stroke-opacity: 0.3;
  }
  .to-point {
    stroke: transparent;
    stroke-width: 11;
    pointer-events: stroke;
  }
  .pixels {
    shape-rendering: crispEdges;
  }
  @media print {
    :host {
      --across: 100% !important;
      --down: 100% !important;
    }
    canvas {
      display: none;
    }
  }
  .label {
    fill: #10131c;
    stroke: #ffffff;
    stroke-width: 3.5px;
    paint-order: stroke;
    text-anchor: middle;
    dominant-baseline: central;
    font-family: var(--mono);
    font-weight: 600;
  }
`;
