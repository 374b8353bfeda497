import type { Way } from '../base/setting.js';
import type { Header } from '../trace/header.js';
import type { Trace } from '../replay/trace.js';
import type { Answer } from './grade.js';
import type { Asks, Kind, Question } from './question.js';

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
  /** Null if the reader gave up. */
  readonly given: Answer | null;
  readonly right: readonly boolean[];
  readonly tries: number;
}

export function runOf({ header, timeline }: Trace): Run {
  const { scene, method, edition, kernel, detail } = header;
  return { scene: scene.name, method, edition, kernel, detail, events: timeline.length };
}

export const isRightAtFirst = ({ right }: Answered): boolean => right.every(Boolean);

interface Count {
  readonly asked: number;
  readonly right: number;
  readonly given_up: number;
}

export function countOf(answers: readonly Answered[]): Count {
  return {
    asked: answers.length,
    right: answers.filter(isRightAtFirst).length,
    given_up: answers.filter(({ given }) => given === null).length,
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
}

interface AnswerWritten {
  readonly step: number;
  readonly kind: Kind;
  readonly way: Way;
  readonly right: boolean;
  readonly given_up: boolean;
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
  const { question, way, given, right, tries } = answered;
  return {
    step: question.step,
    kind: question.kind,
    way,
    right: isRightAtFirst(answered),
    given_up: given === null,
    tries,
    parts: question.parts.map((part, i) => ({
      asks: part.asks,
      options: part.options.map(({ value }) => value),
      given: given?.[i] ?? null,
      right: part.right,
      is_right: right[i] === true,
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
