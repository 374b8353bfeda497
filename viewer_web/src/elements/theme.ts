import { css } from 'lit';

/** The colours and sizes of the page, light and dark. All components inherit them. */
export const tokens = css`
  :host {
    --paper: #eceff3;
    --panel: #ffffff;
    --well: #f5f7f9;
    --ink: #171b24;
    --soft: #566070;
    --line: #d3d9e1;
    --accent: #3446c9;
    --on-accent: #ffffff;
    --accent-wash: #e8ebfc;
    --now: #ffe9a3;
    --now-edge: #c98a00;
    --caller: #f4f0e2;
    --changed: #ffe9a3;
    --pointed: #13bfc6;
    --warn: #8a4b00;
    --warn-wash: #fff1dc;
    --good: #17733a;
    --bad: #a3122b;
    --bad-wash: #fde8eb;
    --mono: ui-monospace, 'SF Mono', 'Cascadia Code', 'DejaVu Sans Mono', Menlo, monospace;
    --sans: system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', 'DejaVu Sans', sans-serif;
    --radius: 8px;
    color: var(--ink);
    font: 0.9375rem / 1.45 var(--sans);
    color-scheme: light;
  }
  @media screen and (prefers-color-scheme: dark) {
    :host {
      --paper: #0f1218;
      --panel: #181c24;
      --well: #11151b;
      --ink: #e6e9ef;
      --soft: #9aa5b5;
      --line: #2d3440;
      --accent: #9aa8ff;
      --on-accent: #10131c;
      --accent-wash: #232a47;
      --now: #57450d;
      --now-edge: #f0b93a;
      --caller: #262319;
      --changed: #57450d;
      --warn: #f3c27a;
      --warn-wash: #33260f;
      --good: #7bd69a;
      --bad: #ff9aa8;
      --bad-wash: #3a151c;
      color-scheme: dark;
    }
  }
  @media print {
    :host {
      --paper: #ffffff;
      --well: #ffffff;
      --ink: #000000;
      --soft: #333333;
      --line: #8a8a8a;
      print-color-adjust: exact;
    }
  }
`;

/** The styles that all components share. */
export const base = css`
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  h2,
  h3,
  p,
  ol,
  ul,
  dl,
  dd,
  figure,
  fieldset,
  legend {
    margin: 0;
    padding: 0;
  }
  fieldset {
    min-width: 0;
    border: 0;
  }
  [hidden] {
    display: none !important;
  }
  h2,
  h3 {
    font-size: 0.75rem;
    font-weight: 600;
    letter-spacing: 0.02em;
    color: var(--soft);
  }
  button,
  input,
  select {
    font: inherit;
    color: inherit;
  }
  button,
  select,
  input[type='number'] {
    min-height: 2rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
  }
  button {
    cursor: pointer;
  }
  button:hover:not(:disabled) {
    border-color: var(--accent);
  }
  button:disabled {
    color: var(--soft);
    opacity: 0.6;
    cursor: default;
  }
  :focus-visible {
    outline: 3px solid var(--accent);
    outline-offset: 2px;
  }
  table {
    border-collapse: collapse;
  }
  .pointed:not(svg *) {
    background: color-mix(in srgb, var(--pointed) 35%, var(--panel));
    box-shadow: 0 0 0 2px var(--pointed);
    color: var(--ink);
  }
  .number {
    font-family: var(--mono);
    font-variant-numeric: tabular-nums;
  }
  .swatch {
    display: inline-block;
    width: 0.8em;
    height: 0.8em;
    margin-right: 0.4em;
    border: 1px solid color-mix(in srgb, var(--ink) 45%, transparent);
    border-radius: 2px;
    vertical-align: -0.05em;
    forced-color-adjust: none;
  }
  /* With the system's colours, fills mark what is current or chosen, and frames mark what has changed or is pending. */
  @media (forced-colors: active) {
    :is(.now, [aria-current='step'], .entered > h3, tr[aria-current='true'] > *),
    button[aria-pressed='true'] {
      background: Highlight !important;
      color: HighlightText !important;
      forced-color-adjust: none;
    }
    button[aria-pressed='true'] * {
      color: inherit;
    }
    :is(.changed, .pointed):not(svg *) {
      outline: 2px solid Highlight;
      outline-offset: -1px;
    }
    .caller {
      outline: 1px dashed CanvasText;
      outline-offset: -1px;
    }
  }
`;

/** For screen readers only. */
export const hiddenStyle = css`
  .heard {
    position: absolute;
    width: 1px;
    height: 1px;
    margin: -1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
`;

/** A dialog over the page. */
export const dialogStyle = css`
  dialog {
    max-width: min(54rem, calc(100vw - 2rem));
    padding: 1.25rem 1.5rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    color: var(--ink);
  }
  dialog::backdrop {
    background: rgb(10 12 18 / 45%);
  }
  /* It has the focus at first, but cannot be pressed. */
  h2:focus {
    outline: none;
  }
  h2 {
    margin-bottom: 0.75rem;
    font-size: 1rem;
    color: var(--ink);
  }
`;

/**
 * The least side of a picture's box. With its margins, a square area then has 280 CSS pixels. The page scrolls if there is
 * less room.
 */
export const leastPicture = css`20rem`;

/** The room for the zoom buttons above a picture that fills the width of a phone. */
export const zoomButtons = css`1.4rem`;

/** The least side with a border. */
export const leastPanel = css`calc(20rem + 2px)`;

/** A screen of this height has room for all controls of a lesson below a picture that fills the width of a phone. */
export const tallScreen = css`740px`;

/** A screen so low, as that of a phone on its side, that the controls stand beside the picture. */
export const lowScreen = css`(max-height: 479px) and (min-width: 560px)`;

/** The height of the controls that a lower screen leaves out. */
export const moreControls = css`5.2rem`;
