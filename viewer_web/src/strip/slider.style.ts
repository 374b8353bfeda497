import { css } from 'lit';
import { stripHeight } from './lanes.js';

/** The thumb's centre is at the place of the step on the strip: half a thumb from both ends. */
export const sliderStyle = css`
  :host {
    --thumb: 1rem;
    position: relative;
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 0 0.5rem;
    align-items: center;
  }
  .slider {
    appearance: none;
    width: 100%;
    height: 1.5rem;
    margin: 0;
    border-radius: 4px;
    background: none;
    contain: strict;
    cursor: pointer;
  }
  .slider::-webkit-slider-runnable-track {
    height: 0.3rem;
    border-radius: 0.15rem;
    background: color-mix(in srgb, var(--soft) 45%, var(--panel));
  }
  .slider::-moz-range-track {
    height: 0.3rem;
    border-radius: 0.15rem;
    background: color-mix(in srgb, var(--soft) 45%, var(--panel));
  }
  .slider::-webkit-slider-thumb {
    appearance: none;
    width: var(--thumb);
    height: var(--thumb);
    margin-top: -0.35rem;
    border: 0;
    border-radius: 50%;
    background: var(--accent);
  }
  .slider::-moz-range-thumb {
    width: var(--thumb);
    height: var(--thumb);
    border: 0;
    border-radius: 50%;
    background: var(--accent);
  }
  vidno-overview,
  .strip {
    margin: 0 calc(var(--thumb) / 2);
  }
  vidno-overview {
    grid-row: 2;
    grid-column: 1;
    display: var(--strip, block);
  }
  .strip,
  .lanes {
    grid-row: 3;
  }
  .strip {
    grid-column: 1;
    position: relative;
    display: var(--strip, block);
    height: ${stripHeight}px;
    contain: layout size;
    cursor: pointer;
    touch-action: pan-y;
    user-select: none;
  }
  .strip vidno-strip {
    height: 100%;
  }
  .strip:focus-visible {
    outline-offset: 2px;
  }
  .now,
  .flag {
    position: absolute;
    top: 0;
    left: calc(var(--at) * 100%);
    height: 100%;
    pointer-events: none;
  }
  .veil {
    position: absolute;
    inset: 0 0 0 calc(var(--at) * 100%);
    background: repeating-linear-gradient(135deg, var(--well) 0 6px, var(--line) 6px 7px);
  }
  .now {
    width: 2px;
    margin-left: -1px;
    background: var(--ink);
    box-shadow: 0 0 0 1px var(--panel);
  }
  .flag {
    width: 9px;
    margin-left: -1px;
    fill: var(--accent);
    stroke: var(--panel);
    stroke-width: 1;
    paint-order: stroke;
    overflow: visible;
  }
  .tip {
    position: absolute;
    bottom: ${stripHeight + 2}px;
    left: calc(var(--at) * 100%);
    z-index: 2;
    width: max-content;
    max-width: 100%;
    padding: 0.25rem 0.55rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    box-shadow: 0 2px 10px rgb(10 12 18 / 25%);
    font-size: 0.8125rem;
    line-height: 1.25;
    overflow-wrap: anywhere;
    transform: translateX(calc(var(--at) * -100%));
    pointer-events: none;
  }
  .whole {
    position: absolute;
    top: 0;
    right: 0;
    z-index: 1;
    display: grid;
    place-items: center;
    width: 1.75rem;
    min-height: 1.5rem;
    height: 1.5rem;
    padding: 0;
    color: var(--soft);
  }
  .whole svg {
    width: 1.1rem;
    height: 1.1rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.6;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .lanes {
    grid-column: 2;
    position: relative;
    align-self: stretch;
    width: 4.1rem;
    color: var(--soft);
    font-size: 0.6875rem;
    line-height: 1;
  }
  .lanes span {
    position: absolute;
    display: flex;
    align-items: center;
    white-space: nowrap;
  }
  /* The system's colours would hide the track and the thumb. */
  @media (forced-colors: active) {
    .slider {
      forced-color-adjust: none;
    }
    .slider::-webkit-slider-runnable-track {
      background: CanvasText;
    }
    .slider::-moz-range-track {
      background: CanvasText;
    }
    .slider::-webkit-slider-thumb {
      background: Highlight;
      box-shadow: 0 0 0 2px Canvas;
    }
    .slider::-moz-range-thumb {
      background: Highlight;
      box-shadow: 0 0 0 2px Canvas;
    }
    .flag {
      fill: CanvasText;
    }
  }
  @container (max-width: 800px) {
    .lanes {
      width: auto;
    }
    .lanes span {
      display: none;
    }
    /* There is no room beside the legend, but beside the strip. */
    .whole {
      top: auto;
      bottom: 0.9rem;
      width: 1.5rem;
      height: 1.5rem;
    }
  }
  .found {
    position: absolute;
    bottom: 0;
    left: calc(var(--at) * 100%);
    width: 2px;
    height: 5px;
    background: #0b7a4b;
    pointer-events: none;
  }
  .found.narrow {
    bottom: 5px;
    background: #b25e00;
  }
`;
