import { html } from 'lit';
import type { TemplateResult } from 'lit';
import type { StatePart } from '../algorithm/shows.js';
import type { PageView, Way } from '../base/setting.js';
import '../compare/comparison-element.js';
import type { Act } from '../editor/editor.js';
import { speedFor } from '../elements/clock.js';
import { texts } from '../i18n/index.js';
import type { Check } from '../exactness/truth.js';
import { nameIn } from '../language/scene-name.js';
import { needsExact } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import '../player/player.js';
import type { Front } from '../player/player.js';
import { isComparedUnasked } from '../player/verdict.js';
import type { Keeper } from '../predict/keeper.js';
import type { Setup } from '../reader/address.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Trace } from '../replay/trace.js';
import { deviationOf } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import { brokenBeside } from './breaking.js';
import type { Breaking } from './breaking.js';
import type { Moving, Navigation } from './navigation.js';
import type { Session } from './session.js';

/** What the stage shows, how, and the callbacks for its controls. */
export interface Shown {
  readonly session: Session;
  readonly setup: Setup;
  readonly view: PageView;
  /** Whether the text of a lesson is beside the run. */
  readonly isReading: boolean;
  /** Whether the reader has opened the page without an address. */
  readonly isFirst: boolean;
  /** The parts of the state that the lesson asks for. */
  readonly parts: readonly StatePart[];
  /** The procedures and lines that the lesson explains, and whether no other lesson comes before it. */
  readonly listed: readonly string[];
  readonly isFirstLesson: boolean;
  /** What is in front on a screen that has no room for both the text and the panels. */
  front: Front;
  /** Called when another panel is opened beside the run. */
  turned(): void;
  change(part: Partial<Setup>): void;
  copyLink(): Promise<void>;
  requestUpdate(): void;
  readonly breaking: Breaking;
  readonly keeper: Keeper | null;
  readonly ways: Navigation;
}

/** Whether the verdict on a run waits for a comparison that nobody needs to request. */
function isAwaited({ isResting, place, steps }: Session, trace: Trace): boolean {
  const isOver = trace.complete && place.step >= steps;
  return isOver && isResting && isComparedUnasked(trace);
}

/** The exact picture, computed while its layer is shown, or for the verdict. Runs of curves have none. */
function exactOf({ session, setup }: Shown): Exact {
  const { trace, exact } = session;
  if (trace === null) return null;
  const { header } = trace;
  if (header.scene.curves !== null) return null;
  const isWanted = needsExact(setup.layer) || isAwaited(session, trace);
  return isWanted ? exact.of(header) : exact.unasked(header);
}

/** The check of the run. For the verdict on a run of curves it begins without a request. */
function checkOf({ session }: Shown): Check | null {
  const { trace, checks } = session;
  if (trace === null || checks === null) return null;
  const check = checks.of(trace);
  const isWanted =
    trace.header.scene.curves !== null && check.is === 'unchecked' && isAwaited(session, trace);
  // Not now, since it changes what the page renders.
  if (isWanted) queueMicrotask(() => checks.ask(trace));
  return check;
}

/** The player. It is hidden while its run is shown beside another one. */
export function alone(page: Shown): TemplateResult {
  const { session } = page;
  const { place, live } = session;
  const { language, presenting, layer, setting } = page.setup;
  const trace = session.isCompared ? null : session.trace;
  return html`
    <vidno-player
      .trace=${trace}
      .length=${session.steps}
      ?complete=${trace?.complete === true}
      .step=${place.step}
      .lang=${language}
      ?hidden=${trace === null}
      .pixel=${place.pixel}
      .bookmarks=${place.bookmarks}
      .from=${setting.from}
      .to=${setting.to}
      .speed=${setting.speed ?? (page.isFirst ? speedFor(session.steps) : null)}
      ?play=${setting.play}
      .controls=${setting.controls}
      .ask=${setting.ask ?? ''}
      .keeper=${page.keeper}
      ?presenting=${presenting && trace !== null}
      layout=${page.view}
      ?beside=${page.isReading}
      .front=${page.isReading ? page.front : null}
      @vidno-front=${({ detail }: CustomEvent<Front>) => (page.front = detail)}
      .parts=${page.parts}
      .listed=${page.listed}
      .isFirstLesson=${page.isFirstLesson}
      ?welcome=${page.isFirst}
      ?linked=${session.isLinked}
      .layer=${layer}
      .exact=${exactOf(page)}
      .maps=${session.maps}
      .margin=${live.editing?.chosen ? trace && session.marginAt(trace, live.editing.chosen) : null}
      .check=${checkOf(page)}
      .editing=${live.editing}
      .link=${live.link}
      ?breakable=${session.canRun}
      @vidno-break=${({ detail }: CustomEvent<Edition>) => page.breaking.break(detail)}
      @vidno-step=${stepped(page, session)}
      @vidno-pixel=${({ detail: pixel }: CustomEvent<Pixel | null>) => session.move({ pixel })}
      @vidno-layer=${({ detail }: CustomEvent<Layer>) => page.change({ layer: detail })}
      @vidno-bookmarks=${({ detail: bookmarks }: CustomEvent<Bookmarks>) => session.move({ bookmarks })}
      @vidno-act=${({ detail }: CustomEvent<Act>) => live.act(detail)}
      @vidno-ask=${({ detail: ask }: CustomEvent<Way>) => page.change({ setting: { ...setting, ask } })}
      @vidno-present=${({ detail }: CustomEvent<boolean>) => page.change({ presenting: detail })}
      @vidno-check=${() => trace && session.checks?.ask(trace)}
      @vidno-keys=${({ detail: keys }: CustomEvent<string>) => page.change({ setting: { ...setting, keys } })}
      @vidno-side=${() => page.turned()}
      @vidno-save=${() => live.save()}
      @vidno-link=${() => page.copyLink()}
    ></vidno-player>
  `;
}

/** Moves a run. The way to a first difference belongs to the break that asked for it. */
const stepped =
  ({ breaking, ways }: Shown, run: Moving) =>
  (event: CustomEvent<number>): void => {
    if (breaking.seeks) run.move({ step: event.detail });
    else ways.moved(event, run);
  };

/** The smallest scene that shows how a line is broken: its right run beside the broken one. */
function smallest(page: Shown): TemplateResult {
  const { witness } = page.session;
  const { right, broken, place, edition, title } = witness;
  const { language, presenting, layer, setting } = page.setup;
  return html`<vidno-comparison
    .trace=${right}
    .length=${right?.timeline.length ?? 0}
    .step=${place.step}
    .rival=${broken}
    .rivalLength=${broken?.timeline.length ?? 0}
    complete
    .lang=${language}
    .pixel=${place.pixel}
    .bookmarks=${[]}
    .speed=${setting.speed}
    ?presenting=${presenting}
    .layer=${layer}
    .broken=${edition && deviationOf(edition)}
    .smallest=${title?.[language] ?? ''}
    ?seeks=${page.breaking.seeks}
    @vidno-broken=${({ detail }: CustomEvent<string>) => page.breaking.follow(detail)}
    @vidno-sought=${() => page.breaking.found()}
    @vidno-step=${stepped(page, witness)}
    @vidno-pixel=${({ detail: pixel }: CustomEvent<Pixel | null>) => witness.move({ pixel })}
    @vidno-layer=${({ detail }: CustomEvent<Layer>) => page.change({ layer: detail })}
    @vidno-present=${({ detail }: CustomEvent<boolean>) => page.change({ presenting: detail })}
    @vidno-keys=${({ detail: keys }: CustomEvent<string>) => page.change({ setting: { ...setting, keys } })}
  ></vidno-comparison>`;
}

/** The run beside another one. */
export function besides(page: Shown): TemplateResult {
  const { session } = page;
  if (session.witness.isOpen) return smallest(page);
  const { place, live, rival } = session;
  const { language, presenting, layer, setting } = page.setup;
  return html`<vidno-comparison
    .trace=${session.trace}
    .length=${session.steps}
    .step=${place.step}
    .check=${session.trace && (session.checks?.of(session.trace) ?? null)}
    .rival=${rival.trace}
    .rivalLength=${rival.steps}
    ?complete=${session.trace?.complete === true && rival.trace?.complete === true}
    .rivalNote=${noteOf(page)}
    .lang=${language}
    .pixel=${place.pixel}
    .bookmarks=${place.bookmarks}
    .from=${setting.from}
    .to=${setting.to}
    .speed=${setting.speed}
    ?presenting=${presenting}
    .layer=${layer}
    .editing=${live.editing}
    .broken=${brokenBeside(session)}
    ?breakable=${session.canRun}
    ?seeks=${page.breaking.seeks && session.witness.edition === null}
    @vidno-break=${({ detail }: CustomEvent<Edition>) => page.breaking.break(detail)}
    @vidno-broken=${({ detail }: CustomEvent<string>) => page.breaking.follow(detail)}
    @vidno-sought=${() => page.breaking.found()}
    @vidno-step=${stepped(page, session)}
    @vidno-pixel=${({ detail: pixel }: CustomEvent<Pixel | null>) => session.move({ pixel })}
    @vidno-layer=${({ detail }: CustomEvent<Layer>) => page.change({ layer: detail })}
    @vidno-bookmarks=${({ detail: bookmarks }: CustomEvent<Bookmarks>) => session.move({ bookmarks })}
    @vidno-check=${() => session.trace && session.checks?.ask(session.trace)}
    @vidno-act=${({ detail }: CustomEvent<Act>) => live.act(detail)}
    @vidno-present=${({ detail }: CustomEvent<boolean>) => page.change({ presenting: detail })}
    @vidno-keys=${({ detail: keys }: CustomEvent<string>) => page.change({ setting: { ...setting, keys } })}
  ></vidno-comparison>`;
}

/** A description of the other run, if its header does not suffice. */
function noteOf({ session, setup }: Shown): string {
  const { rival, trace } = session;
  if (rival.chosen?.kind === 'before') return texts[setup.language].compare.before;
  const name = rival.trace?.header.scene.name ?? '';
  return name === trace?.header.scene.name ? '' : nameIn(setup.language, name);
}
