import type { Way } from '../base/setting.js';
import type { Header } from '../trace/header.js';
import type { Trace } from '../replay/trace.js';
import type { Answer } from './grade.js';
import type { Asks, Kind, Question } from './question.js';
import { pointsOf } from './sheet.js';
import type { Sheet } from './sheet.js';

/** The settings that distinguish a run from others. */
export interface Run extends Pick<Header, 'method' | 'edition' | 'kernel' | 'detail'> {
  readonly scene: string;
  readonly events: number;
}

/** A question with its first answer, which counts. */
export interface Answered {
  readonly run: Run;
  readonly way: Way;
  readonly question: Question;
  /** The sheet of the first answer, with the hints taken for it. */
  readonly sheet: Sheet;
  /** Null if the reader gave up. */
  readonly given: Answer | null;
  readonly right: readonly boolean[];
  readonly tries: number;
}

export function runOf({ header, timeline }: Trace): Run {
  const { scene, method, edition, kernel, detail } = header;
  return { scene: scene.name, method, edition, kernel, detail, events: timeline.length };
}

const isRightAtFirst = ({ right }: Answered): boolean => right.every(Boolean);

export interface Count {
  readonly asked: number;
  readonly right: number;
  readonly given_up: number;
  /** A point for each part that was right at the first answer, less the cost of hints. */
  readonly points: number;
  /** The most points possible. */
  readonly parts: number;
}

export const inHundredths = (points: number): number => Math.round(points * 100) / 100;

const pointsFor = ({ question, right, sheet }: Answered): number =>
  pointsOf(question, right, sheet);

export function countOf(answers: readonly Answered[]): Count {
  return {
    asked: answers.length,
    right: answers.filter(isRightAtFirst).length,
    given_up: answers.filter(({ given }) => given === null).length,
    points: inHundredths(answers.reduce((sum, each) => sum + pointsFor(each), 0)),
    parts: answers.reduce((sum, { question }) => sum + question.parts.length, 0),
  };
}

function grouped<K extends string>(
  answers: readonly Answered[],
  key: (answered: Answered) => K,
): ReadonlyMap<K, readonly Answered[]> {
  const keys = new Set(answers.map(key));
  return new Map([...keys].map((each) => [each, answers.filter((one) => key(one) === each)]));
}

interface PartWritten {
  readonly asks: Asks;
  readonly options: readonly string[];
  readonly given: readonly string[] | null;
  readonly right: readonly string[];
  readonly is_right: boolean;
  readonly hints: number;
}

interface AnswerWritten {
  readonly step: number;
  readonly kind: Kind;
  readonly way: Way;
  readonly right: boolean;
  readonly given_up: boolean;
  readonly points: number;
  readonly tries: number;
  readonly parts: readonly PartWritten[];
}

/** The file of a score, `vidno-score/1`. */
export interface Score {
  readonly format: 'vidno-score/1';
  readonly name?: string;
  readonly total: Count;
  readonly kinds: Readonly<Partial<Record<Kind, Count>>>;
  readonly runs: readonly (Run & { readonly answers: readonly AnswerWritten[] })[];
}

function written(answered: Answered): AnswerWritten {
  const { question, way, given, right, tries, sheet } = answered;
  return {
    step: question.step,
    kind: question.kind,
    way,
    right: isRightAtFirst(answered),
    given_up: given === null,
    points: inHundredths(pointsFor(answered)),
    tries,
    parts: question.parts.map((part, i) => ({
      asks: part.asks,
      options: part.options.map(({ value }) => value),
      given: given?.[i] ?? null,
      right: part.right,
      is_right: right[i] === true,
      hints: sheet[i]?.hints ?? 0,
    })),
  };
}

export function scoreOf(answers: readonly Answered[], name: string): Score {
  const byKind = grouped(answers, ({ question }) => question.kind);
  const byRun = grouped(answers, ({ run }) => JSON.stringify(run));
  return {
    format: 'vidno-score/1',
    ...(name === '' ? {} : { name }),
    total: countOf(answers),
    kinds: Object.fromEntries([...byKind].map(([kind, some]) => [kind, countOf(some)])),
    runs: [...byRun.values()].flatMap((some) =>
      some.slice(0, 1).map(({ run }) => ({ ...run, answers: some.map(written) })),
    ),
  };
}
