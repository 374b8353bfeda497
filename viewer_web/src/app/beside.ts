import { html } from 'lit';
import type { TemplateResult } from 'lit';
import { texts } from '../i18n/index.js';
import type { Lesson, LessonTrace } from '../lessons/lessons.js';
import type { Setup } from '../reader/address.js';
import '../reader/lesson-list.js';
import '../reader/reader-element.js';
import type { Read } from '../reader/reader-element.js';
import type { Navigation } from './navigation.js';
import type { Reading } from './reading.js';
import type { Session } from './session.js';

/** What the page shows beside the run: the lessons, and the text of one of them. */
export interface PageBeside {
  readonly lessons: readonly Lesson[];
  readonly session: Session;
  readonly setup: Setup;
  readonly reading: Reading;
  /** Whether the text of a lesson is beside the run. */
  readonly isReading: boolean;
  change(part: Partial<Setup>): void;
  readonly ways: Navigation;
  closeMenu(): void;
  /** What the page is, for a reader who opens it without an address. */
  greeting(): unknown;
}

/** The lessons, and the headings of the current text. */
export function contents(page: PageBeside): TemplateResult {
  const { lessons, session, setup, reading } = page;
  const { language } = setup;
  return html`<vidno-lesson-list
    .lessons=${lessons}
    .chosen=${session.lesson}
    .setup=${setup}
    .read=${reading.lesson?.id ?? null}
    .story=${reading.story?.story[language] ?? null}
    .heading=${reading.reached.heading}
    @choose=${({ detail }: CustomEvent<LessonTrace>) => {
      page.closeMenu();
      void page.ways.replace(() => reading.choose(detail));
    }}
    @visit=${({ detail }: CustomEvent<string>) => reading.visit(detail)}
    @leave=${() => page.closeMenu()}
    @follow=${({ detail }: CustomEvent<boolean>) => {
      page.change({ follows: detail });
      if (detail) void page.ways.replace(() => reading.go(reading.reached.pin));
    }}
  ></vidno-lesson-list>`;
}

/** The text of the lesson. */
export function reader(page: PageBeside): TemplateResult {
  const { lessons, setup, reading } = page;
  return html`<vidno-divider
      class="fold"
      name="text"
      place="page"
      label=${texts[setup.language].page.sizeOf.text}
      ?hidden=${!page.isReading}
    ></vidno-divider>
    <vidno-reader
      ?hidden=${!page.isReading}
      ?inert=${setup.presenting}
      .story=${reading.story}
      .error=${reading.error}
      .lessons=${lessons}
      .setup=${setup}
      .goal=${reading.goal}
      .current=${reading.current}
      .previous=${reading.neighbour(-1)}
      .next=${reading.neighbour(1)}
      @read=${({ detail }: CustomEvent<Read>) => reading.reach(detail, detail.isScrolled && setup.follows)}
      @pin=${({ detail }: CustomEvent<string>) => page.ways.replace(() => reading.go(detail))}
      >${page.greeting()}</vidno-reader
    >`;
}
