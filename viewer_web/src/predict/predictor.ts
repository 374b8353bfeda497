import type { ReactiveControllerHost } from 'lit';
import type { Language } from '../language/language.js';
import { grade } from './grade.js';
import type { Answer } from './grade.js';
import { moodleXml } from './moodle.js';
import type { Kind, Question } from './question.js';
import { kinds } from './question.js';
import { kindsOf, nextQuestion } from './questions.js';
import { reasonsOf } from './reasons.js';
import type { Reason } from './reasons.js';
import { runOf } from './score.js';
import type { Answered } from './score.js';
import type { Way } from '../base/setting.js';
import type { Trace } from '../replay/trace.js';
import type { Side } from '../history/side-name.js';

/** What is replayed while one predicts. */
export interface Predicted extends ReactiveControllerHost, HTMLElement {
  readonly trace: Trace | null;
  readonly length: number;
  readonly step: number;
  readonly last: number;
  readonly language: Language;
  /** Whether there is a place for questions. */
  readonly isFull: boolean;
  ask: string;
  side: Side;
  moveTo(step: number): void;
}

/** The current question. */
export interface Current {
  readonly question: Question;
  /** Whether its first answer was given, which counts. */
  readonly isAnswered: boolean;
  /** What the last answer came to; null while an answer is asked for. */
  readonly verdict: { readonly given: Answer | null; readonly right: readonly boolean[] } | null;
}

/**
 * Asks what the run does next. An open question is asked at its step: a reader who is free may pass it, one who is not
 * cannot go on. Answers are kept as long as the page.
 */
export class Predictor {
  current: Current | null = null;
  record: readonly Answered[] = [];
  wanted: ReadonlySet<Kind> = new Set(kinds);
  /** Why the current question has its answer. */
  reasons: readonly Reason[] = [];
  /** Whether there was no other question when one was asked for. */
  isOver = false;

  private trace: Trace | null = null;
  /** The questions of this run so far. */
  private asked: readonly Question[] = [];
  /** From where the next question is looked for when it must be answered, which that is, and how far was looked. */
  private from = 0;
  private ahead: Question | null = null;
  private searched = -1;
  private reasoned = '';

  constructor(private readonly host: Predicted) {}

  get isForced(): boolean {
    return this.host.ask === 'forced' && this.host.isFull;
  }

  /** Whether there is a question without an answer: nothing on the page may give it away. */
  get isOpen(): boolean {
    return this.current?.isAnswered === false;
  }

  /** The last step that one may go to. */
  get limit(): number {
    if (!this.isForced) return Infinity;
    const next = this.isOpen ? this.current?.question : this.ahead;
    return next?.step ?? Infinity;
  }

  get offered(): readonly Kind[] {
    return this.trace === null ? [] : kindsOf(this.trace.header);
  }

  /** What the current question is about. */
  get things(): readonly string[] {
    const { current, host } = this;
    return current?.question.step === host.step ? current.question.things : [];
  }

  /** Before a step is shown: looks through the trace, and leaves its timeline anywhere. */
  follow(): void {
    const { trace, step, length } = this.host;
    if (trace !== this.trace) this.begin(trace);
    if (trace === null) return;
    if (this.isOpen && !this.isForced && step !== this.current?.question.step) this.current = null;
    if (this.isForced && !this.isOpen && this.ahead === null && this.searched < length) {
      const from = Math.max(this.from, this.searched);
      this.ahead = nextQuestion(trace, from, this.wanted, this.asked);
      this.searched = length;
    }
    if (this.ahead !== null && step >= this.ahead.step) this.open(this.ahead);
    this.reason(trace);
  }

  private begin(trace: Trace | null): void {
    this.trace = trace;
    this.current = null;
    this.asked = [];
    this.from = 0;
    this.lookAgain();
  }

  /** From here on, for something has changed. */
  private lookAgain(): void {
    this.from = Math.max(this.from, this.host.step);
    this.ahead = null;
    this.searched = -1;
    this.isOver = false;
  }

  private open(question: Question): void {
    this.current = { question, isAnswered: false, verdict: null };
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

  /** To the question that is open, or else to the next one. */
  next(): void {
    const { host } = this;
    if (!host.isFull) return;
    host.side = 'predict';
    if (!this.isOpen) this.find();
    if (this.current !== null && this.isOpen) {
      host.moveTo(this.current.question.step);
      this.current = { ...this.current };
    }
    host.requestUpdate();
  }

  private find(): void {
    const { host, trace, current } = this;
    if (trace === null) return;
    const { step = 0, until = 0 } = current?.question ?? {};
    const from = host.step < step ? host.step : Math.max(host.step, until);
    const found = this.isForced ? this.ahead : nextQuestion(trace, from, this.wanted, this.asked);
    this.isOver = found === null || found.step > host.last;
    if (found !== null && !this.isOver) this.open(found);
  }

  answer(given: Answer): void {
    if (this.current !== null) this.judge(given, grade(this.current.question, given));
  }

  giveUp(): void {
    const { parts } = this.current?.question ?? { parts: [] };
    this.judge(
      null,
      parts.map(() => false),
    );
  }

  /** The question is not asked any more; says whether that may be. */
  leave(): boolean {
    if (this.isOpen && this.isForced) return false;
    this.current = null;
    this.isOver = false;
    return true;
  }

  /** The answer is asked for once more, but not counted. */
  again(): void {
    if (this.current !== null) this.current = { ...this.current, verdict: null };
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
      this.record = [...record, { run: runOf(trace), way, question, given, right, tries: 1 }];
      this.asked = [...this.asked, question];
      this.from = question.until;
      this.lookAgain();
    }
    this.current = { question, isAnswered: true, verdict: { given, right } };
    this.host.requestUpdate();
  }

  /** Whether the run shall stop at each question. */
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
    host.requestUpdate(); // the timeline was left anywhere
    return xml;
  }

  want(kind: Kind, on: boolean): void {
    const others = [...this.wanted].filter((each) => each !== kind);
    this.wanted = new Set(on ? [...others, kind] : others);
    this.lookAgain();
    this.host.requestUpdate();
  }
}
