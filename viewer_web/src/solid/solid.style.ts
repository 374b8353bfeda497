import { css } from 'lit';

/** The looks of the 3D view, in addition to those of the picture. */
export const solidStyle = css`
  :host {
    container-type: inline-size;
    padding: var(--bar, 2.5rem) 0 var(--foot, 0px);
  }
  :host([flat]) {
    --foot: 2.75rem;
  }
  canvas,
  svg {
    inset: var(--bar, 2.5rem) 0 auto;
    width: 100%;
    height: calc(100% - var(--bar, 2.5rem) - var(--foot, 0px));
  }
  canvas {
    object-fit: contain;
    pointer-events: none;
  }
  svg {
    cursor: grab;
    touch-action: none;
  }
  svg:active {
    cursor: grabbing;
  }
  .label {
    font-weight: 500;
    pointer-events: all;
  }
  .label.strong {
    font-weight: 700;
  }
  .views {
    display: var(--tools, flex);
    position: absolute;
    top: 0.375rem;
    left: 0.375rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    overflow: hidden;
    background: var(--panel);
  }
  .views button {
    min-height: 1.75rem;
    padding: 0 0.35rem;
    border: 0;
    border-radius: 0;
    font-size: 0.75rem;
    white-space: nowrap;
  }
  .views button + button {
    border-left: 1px solid var(--line);
  }
  .views button[aria-pressed='true'] {
    background: var(--accent-wash);
    font-weight: 600;
  }
  .views :focus-visible {
    outline-offset: -3px;
  }
  @container (max-width: 320px) {
    vidno-zoom-bar {
      top: auto;
      bottom: calc(var(--foot, 0px) + 0.375rem);
    }
  }
  .missing {
    position: absolute;
    inset: auto 0 0;
    height: var(--foot);
    padding: 0.3rem 0.75rem;
    background: var(--warn-wash);
    color: var(--warn);
    font-size: 0.75rem;
  }
  @media print {
    :host {
      --bar: 0px;
    }
    canvas {
      display: block;
    }
  }
`;
