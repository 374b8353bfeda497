import { css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { sayThing } from '../algorithm/pointed.js';
import { viewOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { showsOf } from '../algorithm/shows.js';
import type { StatePart } from '../algorithm/shows.js';
import { withKey } from '../base/key-map.js';
import type { PageView } from '../base/setting.js';
import { isWay, plain } from '../base/setting.js';
import type { Editing } from '../editor/editor.js';
import type { LinkMade } from '../editor/live.js';
import '../editor/scene-panel.js';
import { announcerStyle } from '../elements/announcer.js';
import '../elements/divider.js';
import { findingMarks } from '../exactness/finding-marks.js';
import { marginMarks } from '../exactness/margin.js';
import type { Margin } from '../exactness/margin.js';
import { takesKey } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import { statement } from '../elements/statement.js';
import { withTerms } from '../elements/term.js';
import {
  base,
  hiddenStyle,
  leastPanel,
  leastPicture,
  lowScreen,
  moreControls,
  tallScreen,
  tokens,
  zoomButtons,
} from '../elements/theme.js';
import type { Check } from '../exactness/truth.js';
import type { History } from '../history/history.js';
import { PixelHistory } from '../history/pixel-history.js';
import type { AtPixel } from '../history/reason.js';
import { reasonMarks } from '../history/reason-marks.js';
import { hasSolid, sideKeys, sideName, whyNoSolid } from '../history/side-name.js';
import type { Side } from '../history/side-name.js';
import { FirstTerms } from '../i18n/glossary.js';
import { texts } from '../i18n/index.js';
import '../listing/listing-element.js';
import type { ListingElement } from '../listing/listing-element.js';
import { needsExact } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import { isOther } from '../picture/pixel.js';
import type { Mark } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Keeper } from '../predict/keeper.js';
import { Predictor } from '../predict/predictor.js';
import type { SignMaps } from '../run/sign-maps.js';
import { bookmarksUpTo } from '../time/bookmarks.js';
import type { Values } from '../replay/values.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Command, TravelElement } from '../time/travel.js';
import './picture-panel.js';
import type { PicturePanelElement } from './picture-panel.js';
import { arrangementOf, isShown } from './panels.js';
import { actionsOf } from './player-keys.js';
import { Pointing } from './pointing.js';
import { presenterStyle } from './presenter.style.js';
import './side.js';
import type { SideElement } from './side.js';
import { Source } from './source.js';
import { StageElement } from './stage-element.js';
import { verdictOn, welcomeOn } from './verdict.js';

/** Whether only the scene was changed: the form and the handles show that, and the rest waits for the run. */
function isOnlyEdited(changed: ReadonlyMap<PropertyKey, unknown>): boolean {
  return (
    changed.size > 0 && [...changed.keys()].every((key) => /^(editing|link)$/.test(String(key)))
  );
}

/** What is in front where there is room for one: the text of a lesson, or the panels of the run. */
export type Front = 'text' | 'run';

/**
 * The picture, the panels of the view beside it, and below both the sentence and the time controls. Where there is no room
 * beside the picture, the panels come last, and the page scrolls to them.
 */
const playerStyle = css`
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
  .beside:has(> .side:is(.exact, .predict, .pixel)) {
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
  .fronts {
    display: none;
    grid-column: 1 / -1;
    gap: 0.25rem;
  }
  .fronts button {
    flex: 1;
    overflow: hidden;
    color: var(--soft);
    font-size: 0.8125rem;
    font-weight: 600;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .fronts button[aria-pressed='true'] {
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
  .exactly {
    color: var(--bad);
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
    .sentence:has(.verdict, .exactly) {
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
    .beside:not(:has(> .scene)):has(> .side:not(.state)) {
      grid-template-areas: 'side' 'listing';
      grid-template-rows: minmax(20rem, auto) 19rem;
    }
    .beside:not(:has(> .scene)):has(> .side:is(.pixel, .outline, .bookmarks, .solid)) {
      grid-template-rows: 22rem 19rem;
    }
    .beside:not(:has(> .scene)):has(> .side.pixel) {
      grid-template-rows: 32rem 19rem;
    }
    .beside:has(> .scene),
    .beside:has(> .scene):not(:has(> .side)) {
      grid-template: 'scene' 22rem 'side' auto 'listing' 19rem / minmax(0, 1fr);
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
    @media (max-width: 899px) {
      :host([front='text']) .beside {
        display: none;
      }
      :host([front]) .fronts {
        display: flex;
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
    .sentence:is(.long, .longest, :has(.verdict, .exactly)) {
      font-size: 0.8125rem;
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
    .sentence {
      height: 4.4rem;
    }
    .sentence:is(.long, .longest, :has(.verdict, .exactly)) {
      font-size: 0.75rem;
    }
  }
  @container (max-width: 350px) {
    .sentence {
      height: 5.4rem;
    }
  }
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  /* The form says how to draw. */
  .stage.drawing .dock {
    position: static;
  }
  /*
   * The controls stay at the lower edge of the screen, and the panels are next to the picture. While a question is asked, the
   * picture stays too, and both would leave it no room.
   */
  @media (min-height: 600px) {
    @container (max-width: 703px) {
      :host(:not([front='text'], [asking])) .stage {
        grid-template-areas: 'picture' 'beside' 'dock';
        grid-template-rows:
          clamp(
            ${leastPanel},
            var(--room, 100dvh - 3.25rem - var(--pad, 0px)) - var(--dock, var(--usual-dock)),
            100cqw + var(--above, 0px) + var(--feet, var(--foot, 2.25rem))
          )
          auto auto;
      }
    }
  }
  @media ${lowScreen} {
    :host(:not([src]):not([presenting])) .stage {
      flex: none;
      min-height: var(--room);
      grid-template:
        'picture dock' auto
        'picture beside' minmax(var(--rest, 9rem), 1fr) / var(--room) minmax(0, 1fr);
    }
    :host([layout='lesson']:not([src]):not([presenting])) .stage {
      height: var(--room);
      --rest: 0px;
    }
    :host(:not([src]):not([presenting])) .picture {
      height: var(--room);
      min-height: 0;
      --least-picture: 0px;
    }
    :host(:not([src]):not([presenting])) .beside {
      display: grid;
      grid-template: 'side' 100% 'listing' 14rem / minmax(0, 1fr);
      gap: var(--gap);
      margin: 0;
      overflow: auto;
      contain: size;
    }
    :host(:not([src]):not([presenting])) .beside:not(:has(> :is(.side:not(.state), .scene))) {
      grid-template: 'listing' minmax(7rem, 1fr) 'side' auto / minmax(0, 1fr);
    }
    :host(:not([src]):not([presenting])) .beside:has(> .scene) {
      grid-template: 'scene' 100% 'side' auto 'listing' 14rem / minmax(0, 1fr);
    }
    :host(:not([src]):not([presenting])) .beside > section {
      contain: content;
    }
    :host(:not([src]):not([presenting])) .dock {
      position: static;
      align-content: start;
      margin: 0 0 var(--gap) var(--gap);
      padding: 0.3rem 0.6rem 0.4rem;
      container-type: inline-size;
    }
    :host(:not([src]):not([presenting])[front='text']) .dock {
      height: var(--dock);
    }
    :host(:not([src]):not([presenting])) .beside {
      margin-left: var(--gap);
    }
    :host(:not([src]):not([presenting])) vidno-divider,
    :host(:not([src]):not([presenting])) .asides {
      display: none;
    }
    :host([front='text']) .beside {
      visibility: hidden;
    }
    :host([front]) .fronts {
      display: flex;
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

/** The player as a part of another page: with a fixed size, and with few controls or none. */
const embeddedStyle = css`
  :host([src]) {
    height: 36rem;
  }
  :host([src][failed]) {
    height: auto;
  }
  /* The surrounding page determines the size. The content scrolls if it does not fit, and never covers the text around it. */
  :host([src]:not([presenting])) {
    overflow: auto;
  }
  :host(:is([controls='small'], [controls='none'])) {
    --least-picture: 0px;
  }
  :host(:is([controls='small'], [controls='none'])) :is(.side, vidno-divider, vidno-travel) {
    display: none;
  }
  :host([controls='none']) vidno-transport {
    display: none;
  }
  :host(:is([controls='small'], [controls='none'])) .stage {
    flex: 1;
    grid-template:
      'picture beside' minmax(0, 1fr)
      'dock dock' auto / minmax(0, 1fr) minmax(0, 1fr);
    gap: 0 var(--gap);
  }
  :host(:is([controls='small'], [controls='none'])) .beside {
    margin: 0;
    grid-template: 'listing' minmax(0, 1fr) / minmax(0, 1fr);
    contain: size;
  }
  :host(:is([controls='small'], [controls='none'])) .dock {
    position: static;
  }
  @container (max-width: 620px) {
    :host(:is([controls='small'], [controls='none'])) .stage {
      grid-template:
        'picture' minmax(0, 1.6fr)
        'beside' minmax(0, 1fr)
        'dock' auto / minmax(0, 1fr);
      gap: var(--gap) 0;
    }
    :host(:is([controls='small'], [controls='none'])) .dock {
      margin: 0;
    }
  }
`;

/**
 * Replays a trace. Set `src`, or `trace` and `length`. The attributes `step`, `pixel`, `bookmarks` and `lang` may be set,
 * and change with the controls. An event `vidno-step` reports each new step, `vidno-pixel` each chosen pixel, and
 * `vidno-bookmarks` changed bookmarks; `linked` states that the page's address contains these.
 */
@customElement('vidno-player')
export class PlayerElement extends StageElement {
  static override styles = [
    tokens,
    base,
    hiddenStyle,
    playerStyle,
    embeddedStyle,
    presenterStyle,
    announcerStyle,
  ];

  /** The address of a trace, or `#id` of a block of JSON Lines in the page. Without it, `trace` and `length` are set. */
  @property() src = '';
  /** The visible controls, see `Controls`; any other value means `full`. */
  @property({ reflect: true }) controls: string = plain.controls;
  @property({ attribute: false, hasChanged: isOther }) pixel: Pixel | null = null;
  /** The layer that the pixels show, if the trace has it. An event `vidno-layer` asks for another one. */
  @property({ attribute: false }) layer: Layer = 'picture';
  /** The source of sign maps; null without the library. */
  @property({ attribute: false }) maps: SignMaps | null = null;
  /** The region to which the chosen vertex can move without changing a sign of the step, if it is known. */
  @property({ attribute: false }) margin: Margin | null = null;
  /** The exact picture of the scene. */
  @property({ attribute: false }) exact: Exact = null;
  @property({ type: Boolean }) linked = false;
  /** The scene, if it can be edited. Events `vidno-act`, `vidno-save` and `vidno-link` carry requests for it. */
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) link: LinkMade | null = null;
  /** Whether lines of the listing can be broken; an event `vidno-break` asks for that. */
  @property({ type: Boolean }) breakable = false;
  /** How questions are asked, see `Way`. An event `vidno-ask` reports that the reader has changed it. */
  @property() ask = '';
  /** What keeps the score of the answers when the page is closed. */
  @property({ attribute: false }) keeper: Keeper | null = null;
  /** Whether a text is beside the player, which leaves room for two columns. */
  @property({ type: Boolean, reflect: true }) beside = false;
  /**
   * What is shown beside a text on a screen without room for both: that text, or the panels of the run. An event `vidno-front`
   * asks to change it.
   */
  @property({ reflect: true }) front: Front | null = null;
  /** The arrangement, and the parts of the state that a lesson asks for. */
  @property({ reflect: true }) layout: PageView = 'workbench';
  @property({ attribute: false }) parts: readonly StatePart[] = [];
  /** The procedures and lines that the lesson explains; in a first lesson nothing else was explained before. */
  @property({ attribute: false }) listed: readonly string[] = [];
  @property({ attribute: false }) isFirstLesson = false;
  /** Whether the reader sees this page for the first time, at the end of a run: its result comes first, in common words. */
  @property({ type: Boolean }) welcome = false;
  /** The query of the outline's search, and the steps found. */
  @state() private sought = '';
  @state() private hits: readonly number[] = [];
  /** What the reader looks at among the reasons of the chosen pixel. */
  @state() private explained: AtPixel | null = null;
  /** The panel beside the listing. */
  @property({ attribute: false }) side: Side = 'state';
  /** Whether the scene is being edited, beside listing and state. */
  @property({ attribute: false }) isEdited = false;
  @query('vidno-listing') readonly listing!: ListingElement;
  @query('vidno-picture-panel') readonly picture!: PicturePanelElement;
  @query('vidno-travel') readonly travel!: TravelElement;
  @query('vidno-side') private panel!: SideElement;
  private view: View | null = null;
  private readonly source = new Source(this);
  private readonly pointing = new Pointing(this);
  readonly predictor = new Predictor(this);
  private readonly chosen = new PixelHistory(this);

  /** The marks of the region to which the chosen vertex can move without changing a sign of the step. */
  private marginMarks(): readonly Mark[] | undefined {
    const { trace, margin, isEdited } = this;
    if (trace === null || margin === null || !isEdited) return undefined;
    const { exact, numbers } = texts[this.language];
    const words = { say: exact.margin, point: numbers.point };
    return marginMarks(margin, trace.header.scene.area, words);
  }

  /** The marks of a reason, while its panel is shown and no question is open that they would answer. */
  private reasonMarks(): readonly Mark[] | undefined {
    const { trace, explained, side, language } = this;
    const { history } = this.chosen;
    const isSeen = side === 'pixel' && !this.predictor.isOpen;
    if (trace === null || history === null || explained === null || !isSeen) return undefined;
    const { short } = texts[language].numbers;
    return reasonMarks(explained, history.pixel, trace.header.scene, short);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // Last of the listeners: the others have used the key or not.
    this.addEventListener('keydown', this.keepKey);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener('keydown', this.keepKey);
  }

  /** In another page, the slides there would turn by a key that was used here. */
  private readonly keepKey = (event: KeyboardEvent): void => {
    const isUsed = event.defaultPrevented || (!event.ctrlKey && takesKey(event));
    if (this.src !== '' && isUsed) event.stopPropagation();
  };

  override willUpdate(changed: PropertyValues<this>): void {
    if (isOnlyEdited(changed)) return;
    this.predictor.follow();
    super.willUpdate(changed);
    if (changed.has('trace')) this.hits = [];
    if (this.trace !== null && this.step < this.length) this.welcome = false;
    if (this.trace !== null) this.bookmarks = bookmarksUpTo(this.bookmarks, this.length);
    this.chosen.follow(changed);
    if (changed.has('trace') || changed.has('pixel') || changed.has('side')) this.explained = null;
    if (changed.has('ask') && isWay(this.ask)) this.side = 'predict';
    this.toggleAttribute('asking', this.side === 'predict');
    const { language, trace } = this;
    const pixel = this.chosen.history?.pixel ?? null;
    const { things: asked } = this.predictor;
    const step = trace === null ? 0 : this.step;
    const findings = trace && this.side === 'exact' ? this.checkOf(trace).findings : undefined;
    const found = findings ? findingMarks(findings, step) : this.marginMarks();
    const { presenting: hall } = this;
    const pointed = this.pointing.at;
    const explained = this.reasonMarks();
    const marks = { ...(found && { found }), ...(explained && { explained }) };
    const choice = { language, pixel, pointed, asked, hall, ...marks };
    const view = trace && viewOf(trace, step, choice);
    this.view = view && { ...view, targets: this.predictor.targetsIn(view) };
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    if (changed.has('side') || changed.has('isEdited')) {
      this.dispatchEvent(new CustomEvent('vidno-side'));
    }
    const isTurned = changed.has('side') || changed.has('front') || changed.has('isEdited');
    if (isTurned && this.isEdited) {
      void this.renderRoot.querySelector('vidno-scene-panel')?.bringIntoSight();
    } else if (isTurned && this.side === 'pixel') void this.panel.bringIntoSight();
  }

  protected override actions(event: KeyboardEvent): Actions {
    return actionsOf(this, event);
  }

  protected override get limit(): number {
    return Math.min(this.last, this.predictor.limit);
  }

  /** Whether all controls and all panels are available. */
  get isFull(): boolean {
    return this.controls !== 'small' && this.controls !== 'none';
  }

  /** Opens a panel. If it is open, opens the state instead. */
  toggleSide(side: Side): void {
    const { view } = this;
    if (!this.isFull || view === null) return;
    const { news } = view.texts;
    const refused = side === 'solid' ? whyNoSolid(view) : null;
    if (refused !== null) this.announcer.refuse(news[refused]);
    else {
      this.side = this.side === side ? 'state' : side;
      this.announcer.say(news.panel(sideName(this.side, view)));
      if (this.side === side) void this.updateComplete.then(() => this.panel.bringIntoSight());
    }
  }

  /** Opens or closes the editor. */
  turnEditor(): void {
    const { view, language } = this;
    if (!this.isFull || view === null || this.editing === null) return;
    this.isEdited = !this.isEdited;
    const { scene } = texts[language].scene;
    this.announcer.say(view.texts.news.panel(this.isEdited ? scene : sideName(this.side, view)));
  }

  /** Closes the questions, unless the run waits for an answer. */
  escape(): void {
    if (this.side !== 'predict') return;
    if (this.predictor.leave()) this.toggleSide('predict');
    else this.refuse('answerFirst');
  }

  refuse(why: 'answerFirst' | 'noComparison'): void {
    this.announcer.refuse(this.view?.texts.news[why] ?? '');
  }

  async openBookmarks(way: 'mark' | 'enter'): Promise<void> {
    if (!this.isFull) return;
    this.side = 'bookmarks';
    await this.updateComplete;
    await this.panel.bookmark(way);
  }

  async enterOutline(): Promise<void> {
    if (!this.isFull) return;
    if (this.side !== 'outline') this.toggleSide('outline');
    await this.updateComplete;
    await this.panel.enterOutline();
  }

  private keepBookmarks(bookmarks: Bookmarks): void {
    this.bookmarks = bookmarks;
    this.dispatchEvent(new CustomEvent('vidno-bookmarks', { detail: bookmarks }));
  }

  override render(): TemplateResult | typeof nothing {
    const { view, trace } = this;
    if (view === null || trace === null) return this.source.remark(this.language);
    const { texts } = view;
    // An open question hides everything that shows the future and would answer it.
    const { isOpen, isForced } = this.predictor;
    const veiled = isOpen || isForced;
    const history = isOpen ? null : this.chosen.history;
    const check = this.checkOf(trace);
    const greeting = this.welcome ? welcomeOn(trace, view, this.exact) : null;
    const verdict = greeting === null ? verdictOn(trace, view, this.exact, check) : null;
    const said = greeting ?? `${verdict ?? ''} ${this.welcome ? '' : view.sentence}`;
    const layer = isOpen && needsExact(this.layer) ? 'picture' : this.layer;
    // The finished picture alone, before anyone asks for a step.
    const pictured = this.welcome ? withoutStep(view) : view;
    return html`
      ${this.source.remark(this.language)}
      <div
        class="stage ${this.edited?.drawn ? 'drawing' : ''}"
        @pointerover=${this.pointing.onOver}
        @pointerleave=${this.pointing.onLeave}
      >
        <div class="dock">
          ${this.announcer.render()}
          <div class="said">
            <p
              class="sentence ${lengthOf(said)}"
              aria-live=${this.clock.playing ? 'off' : 'polite'}
              aria-atomic="true"
            >
              ${greeting === null ? this.said(view, verdict) : html`<span class="welcome">${greeting}</span>`}
            </p>
            ${this.presenter.corner(view)}
          </div>
          ${this.playControls(view, check, history, {
            plain: !this.isFull,
            brief: arrangementOf(this.layout).isBrief,
            veiled,
            hits: this.hits,
          })}
          ${this.asides(view)} ${this.fronts(view)}
        </div>
        <section class="picture" aria-label=${texts.picture}>
          <vidno-picture-panel
            .view=${pictured}
            .editing=${this.edited}
            .layer=${layer}
            .exact=${this.exact}
            @pixel=${({ detail }: CustomEvent<Pixel>) => this.chosen.choose(detail)}
          ></vidno-picture-panel>
        </section>
        <vidno-divider
          class="across"
          name="picture"
          place=${this.layout}
          label=${texts.sizeOf.picture}
        ></vidno-divider>
        <div class="beside">
          <section class="listing" aria-label=${texts.listing}>
            <vidno-listing
              .trace=${this.trace}
              .view=${view}
              .explained=${this.isFirstLesson && this.layout === 'lesson' ? this.listed : null}
              ?hall=${this.presenting}
              ?breakable=${this.breakable && !veiled}
            ></vidno-listing>
          </section>
          ${this.edited === null ? nothing : this.editor(this.edited, view)}
          ${isShown('side', this.layout, this.side, this.presenting || this.hasState(view)) ? this.sidePanel(view, check, history, veiled) : nothing}
        </div>
      </div>
      <p class="heard pointed-at" aria-live="polite">${sayThing(view)}</p>
      ${this.presenter.cover()}
      <vidno-keys
        .texts=${texts}
        ?flat=${!hasSolid(view)}
        @vidno-keys=${() => this.requestUpdate()}
      ></vidno-keys>
    `;
  }

  /**
   * Whether a lesson has a state to show. At the ends of a run, where nothing follows it from step to step, an empty one takes
   * no room.
   */
  private hasState(view: View): boolean {
    const { parts, first, last } = this;
    const isAtEnd = view.step === first || view.step === last;
    const held = showsOf(view).holds(view);
    return isAtEnd ? parts.some((part) => held.includes(part)) : parts.length > 0;
  }

  /** The panels about a step in a lesson, which has no choice between panels. */
  private asides(view: View): TemplateResult | typeof nothing {
    if (!this.isFull || this.presenting || this.layout !== 'lesson') return nothing;
    const sides: readonly Side[] = [
      'exact',
      ...(hasSolid(view) ? ['solid' as const] : []),
      'predict',
    ];
    return html`<div class="asides">${sides.map((side) => this.aside(side, view))}</div>`;
  }

  /** The choice between the text and the panels, on a screen that has no room for both. */
  private fronts(view: View): TemplateResult | typeof nothing {
    if (this.front === null) return nothing;
    const { listing } = view.texts;
    const panel = this.side === 'state' ? listing : sideName(this.side, view);
    const button = (front: Front, name: string): TemplateResult =>
      html`<button
        aria-pressed=${this.front === front ? 'true' : 'false'}
        @click=${() => this.dispatchEvent(new CustomEvent<Front>('vidno-front', { detail: front }))}
      >
        ${name}
      </button>`;
    return html`<div class="fronts" role="group">
      ${button('text', texts[this.language].reader.text)} ${button('run', panel)}
    </div>`;
  }

  private aside(side: Side, view: View): TemplateResult {
    const name = sideName(side, view);
    const open = (): void => (side === 'predict' ? this.predictor.next() : this.toggleSide(side));
    return html`<button
      class=${side}
      aria-pressed=${this.side === side ? 'true' : 'false'}
      title=${withKey(name, sideKeys[side] ?? '')}
      @click=${open}
    >
      ${name}
    </button>`;
  }

  /** The parts of the state that a lesson asks for. A hall sees all parts, since each has its place. */
  private get partsAsked(): readonly StatePart[] | null {
    return this.layout === 'lesson' && !this.presenting ? this.parts : null;
  }

  /** The line of the listing, and what happens there. At the end of the run, the result comes first. */
  private said(view: View, verdict: string | null): TemplateResult {
    return html`<span class="at">${view.event?.at ?? '·'}</span>
      <span class="heard">: </span>
      <span
        >${verdict === null ? nothing : html`<strong class="verdict">${verdict}</strong>`}
        ${this.welcome ? nothing : statement(view.sentence, (line) => withTerms(line, termsIn(view)))}</span
      >`;
  }

  /** The scene while it is edited. */
  private get edited(): Editing | null {
    return this.isEdited ? this.editing : null;
  }

  private editor(editing: Editing, { texts: say }: View): TemplateResult {
    return html`<vidno-divider
        class="under"
        name="scene"
        place=${this.layout}
        label=${say.sizeOf.scene}
      ></vidno-divider>
      <section class="scene" aria-label=${texts[this.language].scene.scene}>
        <vidno-scene-panel
          .editing=${editing}
          .language=${this.language}
          .link=${this.link}
          ?linked=${this.linked}
          @close=${() => this.turnEditor()}
        ></vidno-scene-panel>
      </section>`;
  }

  private sidePanel(
    view: View,
    check: Check,
    history: History | null,
    veiled: boolean,
  ): TemplateResult {
    const { texts } = view;
    return html`<vidno-divider
        class="between"
        name="listing"
        place=${this.layout}
        label=${texts.sizeOf.listing}
      ></vidno-divider>
      <section class="side ${this.side}" aria-label=${sideName(this.side, view)}>
        <vidno-side
          .view=${view}
          .trace=${this.trace}
          .maps=${this.maps}
          .check=${check}
          .history=${history}
          .bookmarks=${this.bookmarks}
          .linked=${this.linked}
          .side=${this.side}
          .sought=${this.sought}
          ?veiled=${veiled}
          .parts=${this.partsAsked}
          .predictor=${this.predictor}
          ?bare=${this.presenting}
          @side=${({ detail }: CustomEvent<Side>) => (this.side = detail)}
          @command=${this.onCommand}
          @search=${({ detail }: CustomEvent<string>) => (this.sought = detail)}
          @hits=${({ detail }: CustomEvent<readonly number[]>) => (this.hits = detail)}
          @forget=${() => this.chosen.choose(null)}
          @explain=${({ detail }: CustomEvent<AtPixel | null>) => (this.explained = detail)}
          .edited=${this.editing === null ? null : this.isEdited}
          @edit=${() => this.turnEditor()}
        ></vidno-side>
      </section>`;
  }

  /** Points at the next or previous thing of the step. */
  point(by: 1 | -1): void {
    if (this.view) this.pointing.move(by, this.view);
  }

  protected override steer(command: Command): void {
    if (command.do === 'bookmarks') this.keepBookmarks(command.bookmarks);
    else super.steer(command);
  }
}

/** How long a sentence is: in a hall or on a phone, a long one has smaller type, so that nothing moves. */
const lengthOf = (said: string): '' | 'long' | 'longest' =>
  said.length < 105 ? '' : said.length < 190 ? 'long' : 'longest';

/** The picture of a run without the marks of a step. */
const withoutStep = (view: View): View => {
  const nothingHeld: Values = { step: view.step, calls: [] };
  return { ...view, event: null, before: nothingHeld, after: nothingHeld };
};

/** The terms of a sentence. A polygon may be named like one. */
const termsIn = ({ language, header }: View): FirstTerms =>
  new FirstTerms(language, (word) => header.scene.byId.has(word));

declare global {
  interface HTMLElementTagNameMap {
    'vidno-player': PlayerElement;
  }
}
