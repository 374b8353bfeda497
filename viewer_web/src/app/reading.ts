import { embeddedFile, idOf } from '../lessons/lessons.js';
import type { Lesson, LessonTrace } from '../lessons/lessons.js';
import { namesNothing } from '../reader/address.js';
import type { Address } from '../reader/address.js';
import type { Goal, Reached } from '../reader/reading-place.js';
import { readStory } from '../reader/story.js';
import type { LessonStory, Pin } from '../reader/story.js';
import type { Place, Session } from './session.js';

/** Milliseconds that the reader has to stay at a pin: a reader who scrolls past faster is on the way elsewhere. */
const stay = 120;

/** The pin with the name of its place, which may be followed by the number of its occurrence. */
export function pinAt(place: string, { pins }: LessonStory): Pin | null {
  return pins.get(place) ?? pins.get(place.replace(/\.\d+$/, '')) ?? null;
}

/** The run or lesson in an address that this page does not have. */
function missingIn(
  { trace, lesson }: Address,
  found: LessonTrace | undefined,
  lessons: readonly Lesson[],
): string | null {
  if (trace !== null && found === undefined) return trace;
  return lesson === null || lessons.some(({ id }) => id === lesson) ? null : lesson;
}

/** The current lesson, the reader's place in its text, and the run that belongs to that place. Reports each change. */
export class Reading {
  lesson: Lesson | null = null;
  /** Its text, once it is read. */
  story: LessonStory | null = null;
  /** Why there is no text. */
  error: unknown = null;
  goal: Goal = { place: null, isRead: false };
  /** The place that the reader has scrolled to. */
  reached: Reached = { place: null, pin: null, heading: null };
  /** The name of the place whose pin has brought the run to its step. */
  current: string | null = null;
  private timer = 0;

  constructor(
    private readonly lessons: readonly Lesson[],
    private readonly session: Session,
    private readonly changed: () => void,
    /** Called before the run goes elsewhere. */
    private readonly leave: () => void,
  ) {}

  /**
   * Opens the lesson and run in an address, or lesson 1 if there are none. A step in the address takes precedence
   * over the text. A scene in the address may have unsaved changes.
   */
  async follow(address: Address, isUnsaved: boolean): Promise<void> {
    const { lesson: id, at, trace: name, entry, live, step, pixel, bookmarks } = address;
    const trace = this.lessons.flatMap(({ traces }) => traces).find((each) => idOf(each) === name);
    const named = this.lessons.find((each) => each.id === id) ?? this.lessonOf(trace);
    const isOpen = namesNothing(address);
    const lesson = named ?? (isOpen ? this.first : null);
    // A reader without an address first sees the result of the run.
    const place = { step: step ?? (isOpen ? Infinity : 0), pixel, bookmarks };
    const opened = this.open(lesson, at);
    const missing = missingIn(address, trace, this.lessons);
    if (missing !== null) this.session.miss(missing);
    if (entry !== null) await this.session.openEntry(entry, address);
    else if (live !== null) void this.session.openCarried(live, place, isUnsaved);
    else if (trace !== undefined) this.show(trace, place);
    else if (lesson !== null && (await opened)) {
      if (at === null) this.goal = { place: null, isRead: false };
      this.begin(lesson, step === null ? at : null, place);
    }
  }

  /** The lesson at which the page opens: lesson 1 of the course, for which lesson 0 only prepares, or else the first one. */
  private get first(): Lesson | null {
    return this.lessons.find(({ id }) => id.startsWith('01-')) ?? this.lessons[0] ?? null;
  }

  /** Opens a single run, with the text of its lesson. */
  choose(trace: LessonTrace): void {
    this.leave();
    const lesson = this.lessonOf(trace) ?? null;
    if (lesson !== this.lesson) void this.open(lesson, null);
    void this.session.openLesson(trace);
  }

  /** Goes to another place in the same text. */
  visit(place: string): void {
    this.goal = { place, isRead: true };
    this.changed();
  }

  close(): void {
    void this.open(null, null);
  }

  /** The previous or next lesson with a text. */
  neighbour(by: 1 | -1): Lesson | null {
    const withText = this.lessons.filter(({ story }) => story !== undefined);
    const own = withText.findIndex((each) => each === this.lesson);
    return own < 0 ? null : (withText[own + by] ?? null);
  }

  /** The reader has scrolled on. If the run follows, it goes to the pin reached. */
  reach(reached: Reached, follows: boolean): void {
    const isOther = reached.pin !== this.reached.pin;
    this.reached = reached;
    if (follows && isOther) this.come(reached.pin);
    this.changed();
  }

  /** The run goes to a pin without delay. */
  go(place: string | null): void {
    clearTimeout(this.timer);
    this.current = place;
    const pin = this.story && place !== null ? pinAt(place, this.story) : null;
    if (pin !== null) this.showPin(pin);
    this.changed();
  }

  /** The trace of a pin. */
  traceOf({ run }: Pin): LessonTrace | undefined {
    const file = this.story?.traces.get(run);
    return this.lesson?.traces.find((trace) => trace.file === file);
  }

  private come(place: string | null): void {
    clearTimeout(this.timer);
    if (place === this.current) return;
    this.current = place;
    // Reading moves the run only while a lesson is open, not an edited scene or the reader's own file.
    const isOwn = this.session.lesson !== null;
    if (place !== null && isOwn) this.timer = window.setTimeout(() => this.go(place), stay);
  }

  private lessonOf(trace: LessonTrace | undefined): Lesson | undefined {
    return this.lessons.find(({ traces }) => trace !== undefined && traces.includes(trace));
  }

  /** Opens a lesson, and returns whether it is still wanted once its text is read. */
  private async open(lesson: Lesson | null, place: string | null): Promise<boolean> {
    clearTimeout(this.timer);
    if (lesson === this.lesson && place === null) return true;
    const goal = { place, isRead: false };
    this.goal = goal;
    if (lesson !== this.lesson) {
      this.lesson = lesson;
      this.story = null;
      this.error = null;
      this.current = null;
      this.reached = { place, pin: null, heading: null };
    }
    await this.read();
    this.changed();
    return this.goal === goal;
  }

  private async read(): Promise<void> {
    const { lesson } = this;
    if (lesson?.story === undefined || this.story !== null) return;
    const file = embeddedFile(document, lesson.story);
    if (file === null) return;
    const [story, error] = await readStory(file).then(
      (read) => [read, null] as const,
      (refusal: unknown) => [null, refusal] as const,
    );
    if (lesson !== this.lesson) return;
    this.story = story;
    this.error = error;
  }

  /** Starts the run of the pin at the place, or else the first one. */
  private begin(lesson: Lesson, at: string | null, place: Place): void {
    const pin = at !== null && this.story !== null ? pinAt(at, this.story) : null;
    const trace = (pin && this.traceOf(pin)) ?? lesson.traces[0];
    if (trace === undefined) return;
    if (pin !== null) this.current = at;
    this.show(trace, pin === null ? place : { ...place, step: pin.step });
    this.changed();
  }

  private show(trace: LessonTrace, place: Place): void {
    if (idOf(trace) === this.session.lesson) this.session.move(place);
    else void this.session.openLesson(trace, place);
  }

  private showPin(pin: Pin): void {
    const { session } = this;
    const trace = this.traceOf(pin);
    if (trace === undefined) return;
    this.leave();
    if (idOf(trace) === session.lesson) session.move({ step: pin.step });
    else void session.openLesson(trace, { step: pin.step, pixel: null, bookmarks: [] });
  }
}
