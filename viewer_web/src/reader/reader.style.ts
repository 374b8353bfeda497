import { css } from 'lit';
import { readerPrint } from './reader-print.style.js';
import { storyStyle } from './story.style.js';

/** The text of a lesson in a scrolling box, and the line above it. */
export const readerStyle = [
  storyStyle,
  css`
    :host {
      display: flex;
      flex-direction: column;
      min-width: 0;
      min-height: 0;
      overflow: hidden;
      border: 1px solid var(--line);
      border-radius: var(--radius);
      background: var(--panel);
      --serif:
        'Iowan Old Style', Charter, 'Source Serif 4', Cambria, 'PT Serif', 'Noto Serif', Georgia,
        'Liberation Serif', 'DejaVu Serif', serif;
    }
    .bar {
      display: flex;
      flex: none;
      gap: 0.75rem;
      align-items: center;
      min-height: 2.1rem;
      padding: 0 0.5rem 0 0.9rem;
      border-bottom: 1px solid var(--line);
      color: var(--soft);
      font-size: 0.8125rem;
    }
    .bar select {
      min-width: 0;
      min-height: 1.6rem;
      margin-left: -0.4rem;
      border-color: transparent;
      background: none;
      text-overflow: ellipsis;
    }
    .bar select:hover {
      border-color: var(--line);
    }
    nav.short {
      display: flex;
      flex: none;
      gap: 0.15rem;
      margin-left: auto;
    }
    nav.short a {
      min-width: 1.75rem;
      border-radius: 5px;
      color: var(--soft);
      line-height: 1.75rem;
      text-align: center;
      text-decoration: none;
    }
    nav.short a:hover {
      background: var(--accent-wash);
      color: var(--ink);
    }
    .box {
      flex: 1;
      min-height: 0;
      overflow: auto;
      overflow-anchor: none;
      overscroll-behavior: contain;
      scrollbar-width: thin;
    }
    .box:focus-visible {
      outline-offset: -3px;
    }
    nav.long {
      display: flex;
      gap: 1rem;
      justify-content: space-between;
      margin-top: 2.5rem;
      padding-top: 1rem;
      border-top: 1px solid var(--line);
      font: 0.875rem / 1.4 var(--sans);
    }
    nav.long a {
      display: grid;
      text-decoration: none;
    }
    nav.long a:hover {
      text-decoration: underline;
    }
    nav.long small {
      color: var(--soft);
      font-size: 0.75rem;
    }
    nav.long .next {
      margin-left: auto;
      text-align: right;
    }
    .refused {
      padding: 0.6rem 0.8rem;
      border-radius: 6px;
      background: var(--bad-wash);
      color: var(--bad);
      font: 0.9375rem / 1.45 var(--sans);
    }
    /* The page itself may scroll. */
    @media (max-width: 899px) {
      .box {
        overscroll-behavior: auto;
      }
      .bar {
        display: none;
      }
    }
  `,
  readerPrint,
];
