import { css } from 'lit';

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
        'header header' 3.25rem 'reader main' minmax(0, 1fr) / minmax(22rem, 5fr)
        minmax(0, 6fr);
      padding-bottom: 0.6rem;
    }
    :host([reading]) nav {
      display: none;
    }
    :host([reading][contents]) nav {
      z-index: 3;
      display: flex;
      grid-area: reader;
      flex-flow: column;
      margin-top: 2.25rem;
      padding: 0;
    }
    :host([reading][contents]) vidno-lesson-list {
      flex: 1;
      max-height: none;
      border-radius: 0 0 var(--radius) var(--radius);
    }
    :host([reading]) vidno-file-drop {
      flex: none;
    }
  }
  @media (max-width: 899px) {
    :host([reading]) {
      grid-template:
        'header' 3.25rem
        'main' 45dvh
        'reader' minmax(0, 1fr) / minmax(0, 1fr);
      gap: 0.5rem 0;
    }
    :host([reading]) main {
      overflow: auto;
      overscroll-behavior: contain;
    }
    :host([reading]) .title :is(h2, p) {
      display: none;
    }
    :host([reading]) .title {
      min-height: 0;
      padding: 0;
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
  @media print {
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
