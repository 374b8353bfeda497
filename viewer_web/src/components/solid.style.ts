import { css } from 'lit';

/** The scene in 3D: over what the picture has. */
export const solidStyle = css`
  :host {
    --bar: 2.5rem;
    padding-top: var(--bar);
  }
  canvas,
  svg {
    inset: var(--bar) 0 0;
  }
  canvas {
    pointer-events: none;
  }
  svg {
    height: calc(100% - var(--bar));
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
    padding: 0 0.5rem;
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
  .missing {
    position: absolute;
    inset: auto 0 0;
    padding: 0.3rem 0.75rem;
    background: var(--warn-wash);
    color: var(--warn);
    font-size: 0.75rem;
  }
  @media print {
    canvas {
      display: block;
    }
  }
`;
