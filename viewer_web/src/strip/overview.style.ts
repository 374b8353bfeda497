import { css } from 'lit';

/** The bar itself takes little room; the area for a finger is larger. */
export const overviewStyle = css`
  :host {
    position: relative;
    display: block;
    height: 0.5625rem;
    touch-action: none;
    user-select: none;
    cursor: crosshair;
  }
  vidno-strip {
    height: 0.4375rem;
    border-radius: 2px;
    overflow: hidden;
  }
  .bar {
    position: absolute;
    inset: 0;
    border-radius: 3px;
  }
  .part,
  .drawn {
    position: absolute;
    top: -2px;
    bottom: 2px;
    left: calc(var(--from) * 100%);
    min-width: 4px;
    width: calc((var(--to) - var(--from)) * 100%);
    border: 1px solid var(--ink);
    border-block-width: 2px;
    border-radius: 3px;
    box-shadow: 0 0 0 1px var(--panel);
    pointer-events: none;
  }
  .part::before,
  .part::after {
    content: '';
    position: absolute;
    top: -2px;
    bottom: -2px;
    width: 4px;
    background: var(--ink);
  }
  .part::before {
    left: -3px;
    border-radius: 3px 0 0 3px;
  }
  .part::after {
    right: -3px;
    border-radius: 0 3px 3px 0;
  }
  .drawn {
    border-color: var(--accent);
    background: color-mix(in srgb, var(--accent) 30%, transparent);
  }
  .outside {
    position: absolute;
    top: 0;
    height: 0.4375rem;
    background: color-mix(in srgb, var(--panel) 62%, transparent);
    pointer-events: none;
  }
  .before {
    left: 0;
    width: calc(var(--from) * 100%);
  }
  .after {
    right: 0;
    left: calc(var(--to) * 100%);
  }
  .now {
    position: absolute;
    top: 0;
    left: calc(var(--at) * 100%);
    width: 2px;
    height: 0.4375rem;
    margin-left: -1px;
    background: var(--ink);
    pointer-events: none;
  }
`;
