import { css } from 'lit';
import {
  leastPanel,
  leastPicture,
  moreControls,
  tallScreen,
  zoomButtons,
} from '../elements/least-picture.js';

/**
 * The picture, the panels of the view beside it, and below both the sentence and the time controls. Where there is no room
 * beside the picture, the panels come last, and the page scrolls to them.
 */
export const playerStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    container-type: inline-size;
    --least-picture: ${leastPicture};
    --gap: 0.625rem;
  }
  /* Hides everything that is only there to be pressed. */
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
  .stage {
    display: grid;
    flex: 1 0 auto;
    grid-template:
      'picture across beside' minmax(min-content, 1fr)
      'dock dock dock' auto / minmax(${leastPanel}, var(--picture, var(--picture-share, 60fr)))
      var(--gap) minmax(0, var(--picture-rest, var(--beside-share, 40fr)));
    min-height: 0;
  }
  .across {
    grid-area: across;
  }
  section,
  .dock {
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  section {
    display: flex;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
  }
  section > * {
    flex: 1;
    min-width: 0;
  }
  /* A change within a panel or the sentence moves nothing outside of it, so a step lays out no more than that. */
  .beside > section,
  .sentence {
    contain: strict;
  }
  .picture {
    grid-area: picture;
  }
  /* The picture alone determines the height of its row. */
  .beside {
    display: grid;
    grid-area: beside;
    grid-template:
      'listing' minmax(0, var(--listing, 1fr))
      'between' var(--gap)
      'side' minmax(0, var(--listing-rest, var(--side-share, 1fr))) / minmax(0, 1fr);
    min-width: 0;
    min-height: 0;
    contain: size;
  }
  .listing {
    grid-area: listing;
  }
  .between {
    grid-area: between;
  }
  .side {
    grid-area: side;
  }
  .scene {
    grid-area: scene;
  }
  .under {
    grid-area: under;
  }
  .beside:not(:has(> .side)) {
    grid-template: 'listing' minmax(0, 1fr) / minmax(0, 1fr);
  }
  .beside:has(> .side.solid) {
    --side-share: 2fr;
    --caption: 9em;
  }
  :host([layout='lesson']) .beside:has(> .side.solid) {
    --caption: 5.3em;
  }
  .beside:has(> .side:is(.exact, .predict)) {
    --side-share: 2fr;
  }
  /* Listing, scene and state below each other. They scroll if there is too little room. */
  .beside:has(> .scene) {
    height: 0;
    min-height: 100%;
    overflow: auto;
  }
  @container (min-width: 704px) {
    .beside:has(> .scene):has(> .side) {
      --before: var(--scene-share, 0.38);
      --after: var(--listing-share, var(--scene-beside, 0.6));
      display: flex;
      flex-direction: column;
    }
    .beside:has(> .side:is(.solid, .exact, .predict)) {
      --scene-beside: 0.45;
    }
    .beside:has(> .scene):has(> .side) > .listing {
      flex: var(--before) 0 0;
      min-height: 8.5rem;
    }
    .beside > .listing ~ .scene:has(~ .side) {
      flex: calc(1 - var(--before)) 0 0;
      min-height: 15rem;
    }
    .beside > .scene ~ .side {
      flex: calc((1 - var(--before)) * (1 - var(--after)) / var(--after)) 0 0;
      min-height: 9rem;
    }
    .beside:has(> .scene):has(> .side) > vidno-divider {
      flex: none;
      height: var(--gap);
    }
  }
  .beside:has(> .scene):not(:has(> .side)) {
    grid-template:
      'listing' minmax(8.5rem, var(--scene, 1fr))
      'under' var(--gap)
      'scene' minmax(15rem, var(--scene-rest, 2fr)) / minmax(0, 1fr);
  }
  .dock {
    z-index: 1;
    display: grid;
    grid-area: dock;
    grid-template-columns: minmax(0, 1fr) auto;
    row-gap: 0.4rem;
    margin-top: var(--gap);
    padding: 0.45rem 0.75rem 0.55rem;
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
    height: 2.85rem;
    overflow: hidden;
    font-size: 1.0625rem;
    line-height: 1.3;
  }
  vidno-transport {
    grid-column: 1 / -1;
  }
  /* Beside the sentence; the Tab key reaches *Play* first. */
  .asides {
    display: flex;
    grid-area: 1 / 2;
    gap: 0.25rem;
    align-self: center;
    margin-left: 0.75rem;
    visibility: var(--quiet, visible);
  }
  .asides button {
    padding: 0 0.55rem;
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .asides button[aria-pressed='true'] {
    border-color: var(--accent);
    color: var(--accent);
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
  /* In a lesson the controls of a panel, and the panels about a step, appear when the reader turns to them. */
  :host([layout='lesson']) :is(vidno-picture-panel, vidno-listing, .dock) {
    --quiet: hidden;
  }
  :host([layout='lesson'])
    :is(vidno-picture-panel, vidno-listing, .dock):is(:hover, :focus-within) {
    --quiet: visible;
  }
  @media (hover: none) {
    :host([layout='lesson']) :is(vidno-picture-panel, vidno-listing, .dock) {
      --quiet: visible;
    }
  }
  .verdict {
    font-weight: 600;
  }
  /* The workbench has three columns where there is room. */
  @container (min-width: 1120px) {
    :host([layout='workbench']:not([beside])) .stage {
      --picture-share: 46fr;
      --beside-share: 54fr;
    }
    :host([layout='workbench']:not([beside])) .beside {
      grid-template:
        'listing between side' minmax(0, 1fr) / minmax(0, var(--listing, 1fr)) var(--gap)
        minmax(0, var(--listing-rest, 1fr));
    }
    /* The scene takes a part of the listing's column; picture and state stay as they are. */
    :host([layout='workbench']:not([beside])) .beside:has(> .scene) {
      display: grid;
      grid-template:
        'listing between side' minmax(0, var(--scene, 1fr))
        'under between side' var(--gap)
        'scene between side' minmax(0, var(--scene-rest, 1.3fr)) / minmax(0, var(--listing, 1fr))
        var(--gap) minmax(0, var(--listing-rest, 1fr));
      overflow: visible;
    }
  }
  @container (min-width: 1500px) {
    .sentence {
      height: 3.6rem;
      font-size: 1.3125rem;
    }
  }
  /* The last sentence has room for the verdict, too, since nothing may move from step to step. */
  @container (max-width: 930px) {
    .sentence:has(.verdict) {
      font-size: 0.8125rem;
      line-height: 1.15;
    }
  }
  /* One column: the picture and the dock fill the screen or the available room, and the panels follow. */
  @container (max-width: 703px) {
    .stage {
      --usual-dock: 8.5rem;
      flex: none;
      grid-template:
        'picture' minmax(
          min-content,
          clamp(
            ${leastPanel},
            var(--room, 100dvh - 3.25rem - var(--pad, 0px)) - var(--dock, var(--usual-dock)),
            100cqw + var(--above, 0px) + var(--feet, var(--foot, 2.25rem))
          )
        )
        'dock' auto
        'beside' auto / minmax(0, 1fr);
    }
    :host([layout='workbench']) .stage {
      --usual-dock: 14.9rem;
    }
    vidno-divider {
      display: none;
    }
    .beside {
      grid-template: 'listing' 19rem 'side' minmax(20rem, auto) / minmax(0, 1fr);
      gap: var(--gap);
      margin-top: var(--gap);
      contain: none;
      overflow-anchor: none; /* A panel that grows does not scroll itself away. */
    }
    .beside > section {
      contain: content;
    }
    /* The requested panel comes first. Panels that grow from step to step scroll their content. */
    .beside:has(> .side:not(.state)) {
      grid-template-areas: 'side' 'listing';
      grid-template-rows: minmax(20rem, auto) 19rem;
    }
    .beside:has(> .side:is(.pixel, .outline, .bookmarks, .solid)) {
      grid-template-rows: 22rem 19rem;
    }
    .beside:has(> .scene),
    .beside:has(> .scene):not(:has(> .side)) {
      grid-template: 'scene' minmax(20rem, auto) 'side' auto 'listing' 19rem / minmax(0, 1fr);
      height: auto;
      overflow: visible;
    }
    .asides {
      display: none;
    }
    /* A tall screen has room for all controls of a lesson, unless the text takes it. */
    @media (min-height: ${tallScreen}) {
      .stage {
        --usual-dock: calc(8.5rem + ${moreControls});
      }
      .asides {
        display: var(--more-controls, flex);
        grid-area: 3 / 1 / auto / -1;
        margin: 0;
      }
    }
    /* A question may be answered in the picture, too. */
    :host([asking]) .picture {
      position: sticky;
      top: 0;
      z-index: 2;
    }
    :host([asking]) .beside {
      --covered: 23rem; /* by the picture */
    }
    .dock {
      position: sticky;
      bottom: 0;
      padding: 0.3rem 0.6rem 0.4rem;
    }
    .sentence {
      height: 3.1rem;
      font-size: 0.875rem;
      line-height: 1.2;
      gap: 0.5rem;
    }
    .sentence:has(.verdict) {
      font-size: 0.75rem;
      line-height: 1.15;
    }
    .sentence .at {
      min-width: 2.8rem;
      font-size: 0.8125rem;
    }
  }
  @container (max-width: 520px) {
    :host(:not([src])) :is(section, .dock) {
      border-inline: 0;
      border-radius: 0;
    }
    .stage {
      --above: ${zoomButtons};
      --feet: 4.25rem; /* the readout and the layers in two lines */
    }
    :host([layout='workbench']) .stage {
      --usual-dock: 16.6rem;
    }
    :host([layout='workbench']) .sentence {
      height: 4.4rem;
    }
  }
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  /* One sheet of A4: the sentence, the picture beside the state, and the listing. */
  @media print {
    :host {
      container-type: normal;
    }
    .stage {
      flex: 1;
      gap: 4mm;
      /* The state must be readable to its end. */
      grid-template:
        'dock dock' auto
        'picture side' minmax(92mm, auto)
        'listing listing' minmax(0, 1fr) / 92mm minmax(0, 1fr);
    }
    .beside {
      display: contents;
    }
    .beside > section,
    .sentence {
      contain: none;
    }
    section {
      border-radius: 0;
    }
    .side {
      zoom: 0.72;
    }
    .listing {
      zoom: 0.8;
    }
    .dock {
      position: static;
      margin: 0;
      padding: 0;
      border: 0;
    }
    :is(vidno-transport, vidno-divider, .asides, .scene) {
      display: none;
    }
  }
`;
