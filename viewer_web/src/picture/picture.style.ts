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
  .of-name {
    stroke: #ffffff;
    stroke-width: 1.5px;
    vector-effect: non-scaling-stroke;
    paint-order: stroke;
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

/** Small samples of the textures of differing pixels. */
export const textureStyle = css`
  i {
    display: inline-block;
    width: 1rem;
    height: 0.75rem;
    margin-right: 0.3rem;
    border-radius: 2px;
    vertical-align: -0.05em;
    background: #ffffff;
  }
  i.wrong {
    background: repeating-linear-gradient(135deg, #10131c 0 3px, #ffffff 3px 6px);
  }
  i.lacking {
    background: radial-gradient(#10131c 1px, #ffffff 1.4px) 0 0 / 4px 4px;
  }
`;
