import { css } from 'lit';
import { leastPanel, leastPicture } from '../elements/least-picture.js';

export const playerStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 0.75rem;
    min-height: 0;
    container-type: inline-size;
    --least-picture: ${leastPicture};
  }
  /* What is only there to be pressed. */
  :host([presenting]),
  :host([controls='none']) {
    --tools: none;
    --legend: none;
  }
  :host([controls='small']) {
    --legend: none;
  }
  @media print {
    :host {
      --tools: none;
      --legend: none;
    }
  }
  .panels {
    display: grid;
    flex: 1 0 auto;
    gap: 0.75rem;
    grid-template-columns: minmax(0, 1fr) minmax(0, 1fr) minmax(18.5rem, 0.62fr);
    grid-template-rows: minmax(min-content, var(--panels, 1fr));
  }
  /* The picture alone says how high its row must be. */
  .panels > :is(.listing, .side) {
    contain: size;
  }
  .panels > section {
    display: flex;
    min-height: 0;
    min-width: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  .panels > section > * {
    flex: 1;
    min-width: 0;
  }
  /* Where the page scrolls, what is said and done stays in sight. */
  .dock {
    position: sticky;
    bottom: 0;
    z-index: 1;
    /* Below the panels; by keyboard one comes to it first. */
    order: 1;
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    flex: none;
    gap: 0.5rem;
    padding: 0.6rem 0.9rem 0.7rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  .said {
    display: flex;
    gap: 0.75rem;
  }
  .sentence {
    display: flex;
    flex: 1;
    gap: 0.75rem;
    align-items: center;
    height: 3.1rem;
    overflow: hidden;
    font-size: 1.125rem;
    line-height: 1.35;
  }
  .sentence .at {
    flex: none;
    min-width: 3.4rem;
    padding: 0.1rem 0.4rem;
    border-radius: 5px;
    background: var(--now);
    font: 600 0.9375rem / 1.5 var(--mono);
    text-align: center;
  }
  @container (min-width: 1500px) {
    .panels {
      grid-template-columns: minmax(0, 1.05fr) minmax(0, 1fr) minmax(24rem, 0.55fr);
    }
    .sentence {
      font-size: 1.375rem;
      height: 3.8rem;
    }
  }
  @container (max-width: 960px) {
    .panels {
      flex: none;
      grid-template-columns: minmax(${leastPanel}, 1fr) minmax(0, 1fr);
      grid-template-rows: minmax(min-content, clamp(24rem, 100dvh - 3rem, 32rem)) 26rem;
    }
    .listing {
      grid-row: 2;
      grid-column: 1 / -1;
    }
  }
  @container (max-width: 620px) {
    .panels {
      grid-template-columns: minmax(0, 1fr);
      grid-template-rows: none;
    }
    .panels > :is(.listing, .side) {
      contain: none;
    }
    .picture {
      order: -2;
      min-height: 106cqw;
    }
    .listing {
      grid-row: auto;
      height: 19rem;
    }
    .side:is(.pixel, .outline, .bookmarks, .solid) {
      order: -1;
      height: 22rem;
    }
    .side:is(.predict, .exact) {
      order: -1;
      height: auto;
    }
    .sentence {
      height: 4.6rem;
      font-size: 0.875rem;
      line-height: 1.3;
      gap: 0.5rem;
    }
    .sentence .at {
      min-width: 2.8rem;
      font-size: 0.8125rem;
    }
    .dock {
      padding: 0.4rem 0.6rem 0.5rem;
    }
  }
  @container (max-width: 400px) {
    :host(:not([src])) :is(.panels > section, .dock) {
      border-inline: 0;
      border-radius: 0;
    }
  }
  /* One sheet, A4: what happened, the picture beside the state, the listing. */
  @media print {
    :host {
      container-type: normal;
      gap: 4mm;
    }
    .panels {
      flex: 1;
      gap: 4mm;
      /* The state is to be read to its end. */
      grid-template: minmax(92mm, auto) minmax(0, 1fr) / 92mm minmax(0, 1fr);
    }
    .panels > section {
      border-radius: 0;
    }
    .panels .picture {
      order: 0;
      height: auto;
    }
    .panels .side {
      order: 1;
      contain: none;
      height: auto;
      zoom: 0.72;
    }
    .panels .listing {
      order: 2;
      grid-row: auto;
      grid-column: 1 / -1;
      height: auto;
      zoom: 0.8;
    }
    .dock {
      position: static;
      order: -1;
      padding: 0;
      border: 0;
    }
    vidno-transport {
      display: none;
    }
  }
`;
