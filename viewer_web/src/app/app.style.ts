import { css } from 'lit';
import { leastPanel, zoomButtons } from '../elements/least-picture.js';
import { languages } from '../language/language.js';

/** The header; below it the text, if there is one, and the run; over these, on demand, the lessons. */
export const appStyle = css`
  :host {
    /* The links to other languages: they come last for the keyboard, but have their place in the header. */
    --languages: ${languages.length - 1};
    --pad: 0.75rem;
    --gap: 0.625rem;
    position: relative;
    box-sizing: border-box;
    display: grid;
    height: 100dvh;
    padding: 0 var(--pad) var(--pad);
    grid-template: 'header' 3rem 'main' minmax(0, 1fr) / minmax(0, 1fr);
    background: var(--paper);
  }
  :host([reading]) {
    grid-template:
      'header header header' 3rem
      'reader fold main' minmax(0, 1fr) / minmax(0, var(--text, var(--text-share, 30fr))) var(--gap)
      minmax(${leastPanel}, var(--text-rest, 70fr));
  }
  vidno-page-header {
    grid-area: header;
    padding-right: calc(5rem * var(--languages));
  }
  vidno-languages {
    grid-area: header;
    justify-self: end;
    height: 3rem;
  }
  vidno-reader {
    grid-area: reader;
  }
  .fold {
    grid-area: fold;
  }
  main {
    grid-area: main;
    display: flex;
    flex-direction: column;
    min-height: 0;
    min-width: 0;
    overflow: auto;
  }
  vidno-player,
  vidno-comparison {
    flex: 1 0 auto;
  }
  /* With a given size the browser need not compute the content's height, for which it would style and lay out everything
     once more. */
  @media (min-width: 900px) {
    vidno-player {
      flex: 1 0 0;
    }
  }
  /* The name and below it the settings of the run. */
  .title {
    display: flex;
    flex-direction: column;
    align-items: flex-start;
    justify-content: center;
    min-width: 0;
  }
  .title > * {
    max-width: 100%;
  }
  .title h2 {
    overflow: hidden;
    color: var(--ink);
    font-size: 1rem;
    line-height: 1.25rem;
    letter-spacing: 0;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .offer {
    margin: 1rem 1.25rem -0.5rem;
    color: var(--soft);
    font-size: 0.875rem;
  }
  .offer a {
    color: var(--accent);
  }
  .on-paper {
    display: none;
  }
  .nothing {
    margin: auto;
    color: var(--soft);
  }
  /* Shown only if reading takes long: the run opens while the reader scrolls, and nothing should flicker. */
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
  nav {
    position: absolute;
    z-index: 5;
    top: 2.9rem;
    left: var(--pad);
    display: none;
    flex-direction: column;
    gap: 0.6rem;
    width: min(26rem, 100% - 2 * var(--pad));
    max-height: calc(100dvh - 3.7rem);
    padding: 0.6rem;
    overflow: auto;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    box-shadow: 0 8px 32px rgb(10 12 18 / 30%);
  }
  :host([contents]) nav {
    display: flex;
  }
  nav > * {
    flex: none;
  }
  /* Without a run the contents hide nothing. */
  :host([empty]) main {
    margin-left: calc(min(26rem, 100% - 2 * var(--pad)) + var(--pad));
  }
  vidno-lesson-list {
    border: 0;
    padding: 0;
  }
  :host([comparing]) nav {
    display: none;
  }
  @media (max-width: 1199px) {
    :host {
      --text-share: 38fr;
    }
  }
  /* The page scrolls: the run comes first, and the box of the text fills the rest of the screen. */
  @media (max-width: 899px) {
    :host {
      height: auto;
      min-height: 100dvh;
      grid-template: 'header' auto 'main' 1fr / minmax(0, 1fr);
    }
    vidno-languages {
      height: 2.75rem;
    }
    vidno-page-header {
      padding-right: 0;
    }
    main {
      overflow: visible;
    }
    :host([empty]) main {
      margin: 0 0.6rem;
    }
    :host([empty]) nav {
      position: static;
      width: auto;
      max-height: none;
      margin: 0 0.6rem 0.6rem;
    }
    .title {
      flex: 1;
    }
    :host([reading]) .fold,
    :host([reading]) vidno-page-header:not([more]) .title {
      display: none;
    }
    :host([reading]) {
      --pad: 0px;
      --foot: 0px;
      --legend: none;
      --more-controls: none;
      --readout: flex;
      --readout-position: absolute;
      --dock: 6.9rem;
      --room: calc(max(${leastPanel}, min(100vw, 50dvh)) + var(--dock));
      grid-template:
        'header' auto
        'main' auto
        'reader' minmax(min(16.4rem, 100dvh), 1fr) / minmax(0, 1fr);
      gap: 0.4rem 0;
    }
    :host([reading][view='workbench']) {
      --dock: 16.6rem;
    }
    /* As high as the picture and the dock; the panels are below, and the page scrolls to them. */
    :host([reading]) main {
      height: var(--room);
      overflow: auto;
    }
    :host([reading]) main:has(> vidno-player[asking]) {
      --room: 0px;
      height: auto;
      overflow: visible;
    }
    :host([reading]) :is(vidno-page-header, vidno-languages, vidno-notice) {
      padding-inline: 0.6rem;
    }
    :host([reading]) vidno-reader {
      contain: size;
      border-width: 1px 0 0;
      border-radius: 0;
    }
  }
  @media (max-width: 640px) {
    :host {
      --pad: 0px;
    }
    :is(vidno-page-header, vidno-languages, vidno-notice) {
      padding-inline: 0.6rem;
    }
    vidno-comparison {
      --name-inset: 0.6rem;
    }
  }
  /* On an upright phone the picture has the full width, and the page scrolls to the text. */
  @media (max-width: 520px) and (orientation: portrait) {
    :host([reading]) {
      --room: calc(max(${leastPanel}, 100vw) + ${zoomButtons} + var(--dock));
    }
  }
  /* Two pictures and their sentences fit on one screen. */
  @media (min-width: 641px) and (max-width: 1199px) {
    vidno-comparison {
      --panels: clamp(20rem, 100dvh - 28.5rem, 36rem);
    }
  }
  :host([embed]) {
    grid-template: 'main' minmax(0, 1fr) / minmax(0, 1fr);
    height: 100dvh;
    padding: 0;
  }
  :host([embed]) :is(vidno-page-header, vidno-languages, nav) {
    display: none;
  }
  @media print {
    :host {
      display: flex;
      flex-direction: column;
      height: 268mm;
      min-height: 0;
      padding: 0;
      overflow: hidden;
    }
    :is(vidno-page-header, vidno-languages, vidno-divider, nav, vidno-notice) {
      display: none;
    }
    main {
      flex: 1;
      overflow: visible;
    }
    .on-paper {
      display: block;
      margin-bottom: 3mm;
      color: var(--ink);
      font-size: 1rem;
      overflow-wrap: anywhere;
    }
    vidno-player,
    vidno-comparison {
      flex: 1;
    }
    :host([reading]) {
      display: block;
      height: auto;
      overflow: visible;
    }
    :host([reading]) :is(main, nav) {
      display: none;
    }
    /* A sheet is as narrow as a small screen. With its size contained the text would be cut between sheets, through its lines. */
    :host([reading]) vidno-reader {
      contain: none;
    }
  }
`;
