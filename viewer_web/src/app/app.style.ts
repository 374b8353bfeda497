import { css } from 'lit';
import { besideStyle } from './beside.style.js';

export const appStyle = [
  css`
    :host {
      box-sizing: border-box;
      display: grid;
      height: 100dvh;
      padding: 0 0.9rem 0.9rem;
      gap: 0 0.9rem;
      grid-template: 'header header' 3.25rem 'nav main' minmax(0, 1fr) / 14rem minmax(0, 1fr);
      background: var(--paper);
    }
    vidno-page-header {
      grid-area: header;
    }
    nav {
      grid-area: nav;
      display: flex;
      flex-direction: column;
      gap: 0.75rem;
      min-height: 0;
    }
    vidno-lesson-list {
      flex: 1;
      min-height: 0;
    }
    main {
      grid-area: main;
      display: flex;
      flex-direction: column;
      min-height: 0;
      min-width: 0;
      overflow: auto;
    }
    .title {
      display: flex;
      flex: none;
      flex-wrap: wrap;
      gap: 0 0.9rem;
      align-items: baseline;
      min-height: 2.1rem;
      padding-bottom: 0.4rem;
    }
    .title h2 {
      font-size: 1.125rem;
      letter-spacing: 0;
      color: var(--ink);
      overflow-wrap: anywhere;
      display: -webkit-box;
      -webkit-box-orient: vertical;
      -webkit-line-clamp: 4;
      overflow: hidden;
    }
    .title p {
      color: var(--soft);
      font-size: 0.8125rem;
    }
    vidno-notice:not(.growing) {
      flex-basis: 100%;
    }
    vidno-player,
    vidno-comparison {
      flex: 1 0 auto;
    }
    .nothing {
      margin: auto;
      color: var(--soft);
    }
    @media (max-width: 1199px) {
      :host {
        height: auto;
        min-height: 100dvh;
        grid-template: 'header' 3.25rem 'nav' auto 'main' 1fr / minmax(0, 1fr);
        gap: 0 0.75rem;
        padding: 0 0.6rem 0.6rem;
      }
      main {
        overflow: visible;
      }
      nav {
        flex-flow: row wrap;
        padding-bottom: 0.6rem;
      }
      vidno-lesson-list {
        flex: 3 1 16rem;
      }
      vidno-file-drop {
        flex: 1 1 12rem;
      }
      .own-surface {
        flex: 1 1 12rem;
        align-self: start;
      }
    }
    /* The page scrolls: one screen holds the panels and the dock, of a comparison what is said, too. */
    @media (min-width: 641px) and (max-width: 1199px) {
      :host(:not([reading], [embed])) vidno-player {
        --panels: clamp(24rem, 100dvh - 14.5rem, 44rem);
      }
      vidno-comparison {
        --panels: clamp(20rem, 100dvh - 28.5rem, 36rem);
      }
    }
    @media (max-width: 640px), (max-width: 1199px) and (max-height: 599px) {
      :host {
        grid-template: 'header' 3.25rem 'main' auto 'nav' auto / minmax(0, 1fr);
      }
      nav {
        padding-block: 0.75rem 0;
      }
    }
    @media (max-width: 640px) {
      :host {
        padding-inline: 0;
      }
      :is(vidno-page-header, nav, .title) {
        padding-inline: 0.6rem;
      }
      vidno-comparison {
        --name-inset: 0.6rem;
      }
    }
    :host([comparing]) {
      grid-template: 'header' 3.25rem 'main' minmax(0, 1fr) / minmax(0, 1fr);
    }
    :host([comparing]) nav {
      display: none;
    }
    :host([embed]) {
      grid-template: 'main' minmax(0, 1fr) / minmax(0, 1fr);
      height: 100dvh;
      padding: 0;
    }
    :host([embed]) :is(vidno-page-header, nav, h2, .title p) {
      display: none;
    }
    :host([embed]) .title {
      min-height: 0;
      padding: 0;
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
      vidno-page-header,
      nav,
      vidno-notice {
        display: none;
      }
      main {
        flex: 1;
        overflow: visible;
      }
      vidno-player,
      vidno-comparison {
        flex: 1;
      }
    }
  `,
  besideStyle,
];
