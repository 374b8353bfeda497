import { css } from 'lit';

/** Handles on corners, in a layer over the picture. */
export const handlesStyle = css`
  svg.drawing {
    cursor: crosshair;
    pointer-events: all;
  }
  svg * {
    vector-effect: non-scaling-stroke;
  }
  .edge {
    fill: none;
    stroke: transparent;
    stroke-width: 12;
    pointer-events: stroke;
    cursor: move;
  }
  .handle {
    cursor: grab;
    pointer-events: all;
    touch-action: none;
    outline: none;
  }
  .reach {
    fill: transparent;
  }
  .knob {
    fill: #ffffff;
    stroke: #10131c;
    stroke-width: 2;
  }
  .chosen .knob {
    fill: #10131c;
    stroke: #ffffff;
  }
  .handle:focus-visible .reach,
  .pen:focus-visible .reach {
    stroke: #5a1fc4;
    stroke-width: 3;
  }
  .line {
    fill: none;
    stroke: #10131c;
    stroke-width: 2;
    stroke-dasharray: 5 4;
  }
  .casing {
    fill: none;
    stroke: #ffffff;
    stroke-width: 5;
  }
  .pen {
    pointer-events: none;
    outline: none;
  }
`;
