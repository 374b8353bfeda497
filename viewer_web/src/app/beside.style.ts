import { css } from 'lit';
import { leastPanel } from '../elements/least-picture.js';

/** The page with the text of a lesson: contents, text and run beside each other, or the run above the text. */
export const besideStyle = css`
  vidno-reader {
    grid-area: reader;
  }
  :host([reading]) {
    height: 100dvh;
    min-height: 0;
    grid-template:
      'header header header' 3.25rem 'nav reader main' minmax(0, 1fr) / 12rem clamp(
        25rem,
        32vw,
        34rem
      )
      minmax(0, 1fr);
  }
  @media (min-width: 1700px) {
    :host([reading]) {
      grid-template-columns: 14rem 34rem minmax(0, 1fr);
    }
  }
  /* Said only if it takes long: the run is opened as one reads, and nothing shall flicker. */
  :host([reading]) vidno-notice.reading {
    position: absolute;
    right: 0.9rem;
    z-index: 2;
    animation: late 0.3s step-end backwards;
  }
  @keyframes late {
    from {
      opacity: 0;
    }
  }
  @media (max-width: 1199px) {
    :host([reading]) {
      min-height: 0;
      grid-template:
        'header header' 3.25rem 'reader main' minmax(0, 1fr) / minmax(0, 1fr)
        minmax(36.5rem, 1.3fr);
      padding-bottom: 0.6rem;
    }
    :host([reading]) nav {
      display: none;
    }
    :host([reading]) main {
      overflow: auto;
    }
    /* Over the text: the lessons take the room, what else there is is scrolled to. */
    :host([reading][contents]) nav {
      z-index: 3;
      display: flex;
      grid-area: reader;
      flex-flow: column;
      margin-top: 2.25rem;
      padding: 0 0.6rem 0.6rem;
      overflow: auto;
      border: 1px solid var(--line);
      border-radius: 0 0 var(--radius) var(--radius);
      background: var(--panel);
    }
    :host([reading][contents]) nav > * {
      flex: none;
    }
    :host([reading][contents]) vidno-lesson-list {
      max-height: none;
      border: 0;
    }
  }
  /* There the text has its title. */
  @media (max-width: 899px), (max-height: 599px) {
    :host([reading]) .title :is(h2, p) {
      display: none;
    }
    :host([reading]) .title {
      min-height: 0;
      padding: 0;
    }
  }
  /* The run and under it the text, each in a box that scrolls; both together may be higher than the screen. */
  @media (max-width: 899px) {
    :host([reading]) {
      height: auto;
      min-height: 100dvh;
      grid-template:
        'header' 3.25rem
        'main' auto
        'reader' minmax(min(18rem, 100dvh), 1fr) / minmax(0, 1fr);
      gap: 0.5rem 0;
    }
    :host([reading]) main {
      height: max(45dvh, ${leastPanel} + 9.25rem);
    }
    :host([reading]) main:has(> vidno-player[asking]) {
      height: auto;
      overflow: visible;
    }
    :host([reading]) :is(vidno-reader, nav) {
      contain: size;
    }
  }
  @media (max-width: 640px) {
    :host([reading]) {
      padding: 0;
    }
    :host([reading]) vidno-page-header {
      padding-inline: 0.6rem;
    }
    :host([reading]) vidno-reader {
      border-width: 1px 0 0;
      border-radius: 0;
    }
  }
  /* The run in a column beside the text, each as high as the screen. */
  @media (min-width: 600px) and (max-width: 899px) and (max-height: 599px) {
    :host([reading]) {
      grid-template:
        'header header' 3.25rem
        'main reader' 100dvh / ${leastPanel} minmax(0, 1fr);
    }
    :host([reading]) main,
    :host([reading]) main:has(> vidno-player[asking]) {
      height: auto;
      overflow: auto;
    }
    :host([reading]) vidno-reader {
      border-radius: 0;
    }
  }
  @media print {
    :host([reading]) vidno-reader {
      contain: none;
    }
    :host([reading]) {
      display: block;
      height: auto;
      overflow: visible;
    }
    :host([reading]) :is(main, nav) {
      display: none;
    }
  }
`;
