import type { ReactiveControllerHost } from 'lit';
import type { Language } from '../language/language.js';
import { grade } from './grade.js';
import type { Answer } from './grade.js';
import { joined } from './keeper.js';
import type { Keeper } from './keeper.js';
import { moodleXml } from './moodle.js';
import type { Kind, Part, Question } from './question.js';
import { kinds, proceduresOf } from './question.js';
import { kindsOf, nextQuestion } from './questions.js';
import { reasonsOf } from './say.js';
import type { Reason } from './say.js';
import { runOf, scoreOf } from './score.js';
import type { Answered, Score } from './score.js';
import { answerOf, emptySheet, filledIn, hinted, pressed } from './sheet.js';
import type { Entry, Sheet } from './sheet.js';
import { targetsOf } from './targets.js';
import type { View } from '../algorithm/view.js';
import type { Way } from '../base/setting.js';
import type { Check } from '../exactness/truth.js';
import type { Target } from '../picture/target.js';
import type { Trace } from '../replay/trace.js';
import type { Side } from '../history/side-name.js';

/**
 * Mere calculations, which would be the first question of each run, are asked only in a lesson about them, or if the reader
 * chooses them.
 */
const calculations: readonly Kind[] = ['plane', 'depth'];
const usual: readonly Kind[] = kinds.filter((kind) => !calculations.includes(kind));

/** The element that replays the run during predictions. */
export interface Predicted extends ReactiveControllerHost, HTMLElement {
  readonly trace: Trace | null;
  readonly length: number;
  readonly step: number;
  readonly last: number;
  readonly language: Language;
  /** Whether there is room for questions. */
  readonly isFull: boolean;
  /** The procedures and lines that the lesson beside the run explains. */
  readonly listed: readonly string[];
  /** What keeps the score when the page is closed, if anything does. */
  readonly keeper: Keeper | null;
  ask: string;
  side: Side;
  /** How the run's decisions are known to be right. */
  checkOf(trace: Trace): Check;
  moveTo(step: number): void;
}

/** The current question. */
export interface Current {
  readonly question: Question;
  readonly sheet: Sheet;
  /** The part that is being answered, whose options can be chosen in the picture too. */
  readonly part: number;
  /** Grows whenever the question is asked, so that the focus goes to it. */
  readonly turn: number;
  /** Whether the first answer, which counts, was given. */
  readonly isAnswered: boolean;
  /** The result of the last answer; null while the question waits for an answer. */
  readonly verdict: { readonly given: Answer | null; readonly right: readonly boolean[] } | null;
}

/**
 * Asks what the run will do next. A question is asked at its step: the reader may pass it, unless questions are forced.
 * Answers are kept as long as the page is open; a `Keeper` keeps the score for longer.
 */
export class Predictor {
  current: Current | null = null;
  record: readonly Answered[] = [];
  wanted: ReadonlySet<Kind> = new Set(usual);
  /** The reasons for the answer to the current question. */
  reasons: readonly Reason[] = [];
  /** Whether the last search found no further question. */
  isOver = false;

  private trace: Trace | null = null;
  /** The questions of this run so far. */
  private asked: readonly Question[] = [];
  /** For forced questions: the step from which to search for the next one, that question, and the step reached so far. */
  private from = 0;
  private ahead: Question | null = null;
  private searched = -1;
  private reasoned = '';
  /** Whether the reader has chosen the kinds of questions. */
  private isChosen = false;
  private listed: readonly string[] = [];

  constructor(private readonly host: Predicted) {}

  get keeper(): Keeper | null {
    return this.host.keeper;
  }

  get isForced(): boolean {
    return this.host.ask === 'forced' && this.host.isFull;
  }

  /** Whether a question is unanswered: nothing on the page may give its answer away. */
  get isOpen(): boolean {
    return this.current?.isAnswered === false;
  }

  /** The last step that the reader can go to. */
  get limit(): number {
    if (!this.isForced) return Infinity;
    const next = this.isOpen ? this.current?.question : this.ahead;
    return next?.step ?? Infinity;
  }

  get offered(): readonly Kind[] {
    return this.trace === null ? [] : kindsOf(this.trace.header);
  }

  /** The things that the current question is about. */
  get things(): readonly string[] {
    const { current, host } = this;
    return current?.question.step === host.step ? current.question.things : [];
  }

  /** Called before a step is shown. Searches the trace, and may leave its timeline at any step. */
  follow(): void {
    const { trace, step, length, listed } = this.host;
    const isNew = trace !== this.trace || listed !== this.listed;
    this.listed = listed;
    if (trace !== this.trace) this.begin(trace);
    if (trace !== null && isNew && !this.isChosen) this.wantWhatIsExplained(trace);
    if (trace === null) return;
    if (this.isOpen && !this.isForced && step !== this.current?.question.step) this.current = null;
    if (this.isForced && !this.isOpen && this.ahead === null && this.searched < length) {
      const from = Math.max(this.from, this.searched);
      this.ahead = this.searchFrom(trace, from);
      this.searched = length;
    }
    if (this.ahead !== null && step >= this.ahead.step) this.open(this.ahead);
    this.reason(trace);
  }

  private searchFrom(trace: Trace, from: number): Question | null {
    const check = this.host.checkOf(trace);
    const wrong = check.is === 'found' ? check.truth.wrong : [];
    return nextQuestion(trace, from, this.wanted, this.asked, wrong);
  }

  /** Asks about the procedures of the lesson, as far as the run has such questions. */
  private wantWhatIsExplained({ header }: Trace): void {
    const explained = kindsOf(header).filter((kind) =>
      proceduresOf[kind].some((name) => this.listed.includes(name)),
    );
    this.wanted = new Set(explained.length > 0 ? explained : usual);
    this.lookAgain();
  }

  private begin(trace: Trace | null): void {
    this.trace = trace;
    this.current = null;
    this.asked = [];
    this.from = 0;
    this.lookAgain();
  }

  /** Searches again from here, because something has changed. */
  private lookAgain(): void {
    this.from = Math.max(this.from, this.host.step);
    this.ahead = null;
    this.searched = -1;
    this.isOver = false;
  }

  private open(question: Question): void {
    this.current = {
      question,
      sheet: emptySheet(question),
      part: 0,
      turn: 0,
      isAnswered: false,
      verdict: null,
    };
    this.ahead = null;
    this.host.side = 'predict';
  }

  private reason(trace: Trace): void {
    const { current, host } = this;
    const { language } = host;
    const { kind, step } = current?.question ?? {};
    const wanted = current?.isAnswered === true ? `${language} ${kind ?? ''} ${step ?? ''}` : '';
    if (wanted === this.reasoned) return;
    this.reasoned = wanted;
    this.reasons = current?.isAnswered === true ? reasonsOf(trace, current.question, language) : [];
  }

  /** Goes to the open question, or else to the next one. */
  next(): void {
    const { host } = this;
    if (!host.isFull) return;
    host.side = 'predict';
    if (!this.isOpen) this.find();
    if (this.current !== null && this.isOpen) {
      host.moveTo(this.current.question.step);
      this.current = { ...this.current, turn: this.current.turn + 1 };
    }
    host.requestUpdate();
  }

  private find(): void {
    const { host, trace, current } = this;
    if (trace === null) return;
    const { step = 0, until = 0 } = current?.question ?? {};
    const from = host.step < step ? host.step : Math.max(host.step, until);
    const found = this.isForced ? this.ahead : this.searchFrom(trace, from);
    this.isOver = found === null || found.step > host.last;
    if (found !== null && !this.isOver) this.open(found);
  }

  /** The places in the picture that answer the part in focus. */
  targetsIn(view: View): readonly Target[] {
    const { current, host } = this;
    if (current?.verdict !== null || current.question.step !== host.step) return [];
    const { question, part, sheet } = current;
    return targetsOf(view, question, part, sheet, (at, value) => this.press(at, value));
  }

  /** Turns to a part, so that the picture offers its options. */
  turnTo(part: number): void {
    if (this.current === null || this.current.part === part) return;
    this.current = { ...this.current, part };
    this.host.requestUpdate();
  }

  private enter(part: number, entryOf: (part: Part, old: Entry) => Entry): void {
    const { current } = this;
    const asked = current?.question.parts[part];
    if (current === null || asked === undefined || current.verdict !== null) return;
    const sheet = current.sheet.map((old, i) => (i === part ? entryOf(asked, old) : old));
    this.current = { ...current, part, sheet };
    this.host.requestUpdate();
  }

  /** Chooses an option, in the panel or in the picture. */
  press(part: number, value: string): void {
    this.enter(part, (asked, old) => pressed(asked, old, value));
  }

  /** Replaces the text of a row. */
  type(part: number, text: string): void {
    this.enter(part, (_, old) => ({ ...old, chosen: text === '' ? [] : [text] }));
  }

  /** Replaces the text in a cell of a table. */
  fillIn(part: number, cell: number, text: string): void {
    this.enter(part, (asked, old) => filledIn(asked, old, cell, text));
  }

  hint(part: number): void {
    this.enter(part, hinted);
  }

  /** Judges the answer on the sheet. */
  answer(): void {
    const { current } = this;
    if (current === null) return;
    const given = answerOf(current.question, current.sheet);
    this.judge(given, grade(current.question, given));
  }

  giveUp(): void {
    const { parts } = this.current?.question ?? { parts: [] };
    this.judge(
      null,
      parts.map(() => false),
    );
  }

  /** Drops the question. Returns whether that is allowed. */
  leave(): boolean {
    if (this.isOpen && this.isForced) return false;
    this.current = null;
    this.isOver = false;
    return true;
  }

  /** Asks the question once more, without counting the answer. */
  again(): void {
    if (this.current !== null)
      this.current = { ...this.current, part: 0, turn: this.current.turn + 1, verdict: null };
    this.host.requestUpdate();
  }

  private judge(given: Answer | null, right: readonly boolean[]): void {
    const { current, trace, record } = this;
    if (current === null || trace === null) return;
    const { question } = current;
    if (current.isAnswered) {
      this.record = record.map((each, i) =>
        i === record.length - 1 ? { ...each, tries: each.tries + 1 } : each,
      );
    } else {
      const way: Way = this.isForced ? 'forced' : 'free';
      const { sheet } = current;
      const answered = { run: runOf(trace), way, question, sheet, given, right, tries: 1 };
      this.record = [...record, answered];
      this.asked = [...this.asked, question];
      this.from = question.until;
      this.lookAgain();
    }
    this.current = { ...current, isAnswered: true, verdict: { given, right } };
    this.keeper?.keep(this.score());
    this.host.requestUpdate();
  }

  /** The score, earlier visits included. */
  score(name = ''): Score {
    return joined(this.keeper?.earlier ?? null, scoreOf(this.record, name));
  }

  /** Sets whether the run stops at each question. */
  force(on: boolean): void {
    const { host } = this;
    host.ask = on ? 'forced' : 'free';
    this.lookAgain();
    host.dispatchEvent(new CustomEvent<Way>('vidno-ask', { detail: on ? 'forced' : 'free' }));
  }

  /** Questions from the whole run as Moodle XML; null if there are none. */
  moodle(): string | null {
    const { host, trace } = this;
    const xml = trace === null ? null : moodleXml(trace, host.language);
    host.requestUpdate(); // the timeline may be at any step
    return xml;
  }

  want(kind: Kind, on: boolean): void {
    this.isChosen = true;
    const others = [...this.wanted].filter((each) => each !== kind);
    this.wanted = new Set(on ? [...others, kind] : others);
    this.lookAgain();
    this.host.requestUpdate();
  }
}
