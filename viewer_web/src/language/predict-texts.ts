import type { Abouts, Asks, Becomes, Column, Form, Kind, tests } from '../predict/question.js';
import type { Event } from '../trace/events.js';
import type { Relation } from './words.js';

/** The texts of predictions. */
export interface PredictTexts {
  readonly title: string;
  /** Includes the key if single-character keys are on. */
  readonly hint: (key: string | null) => string;
  readonly next: string;
  readonly none: string;
  readonly forced: string;
  readonly forcedHint: string;
  readonly askAbout: string;
  readonly kinds: Readonly<Record<Kind, string>>;
  readonly intro: { readonly [K in Kind]: (about: Abouts[K]) => string };
  readonly asks: Readonly<Record<Asks, string>>;
  /** The format of an answer of several values. */
  readonly rows: Readonly<Record<'signs' | 'cornerSigns' | 'list' | 'order' | 'walked', string>>;
  /** A table of numbers: the names of its rows, from 1, and of its columns, and how to write a number. */
  readonly table: {
    readonly entry: (number: number) => string;
    readonly columns: Readonly<Record<Column, string>>;
    readonly hint: string;
  };
  /** The text in the places after the end of a row. */
  readonly ends: PredictTexts['rows'];
  readonly crossing: string;
  readonly area: string;
  readonly noPolygon: Readonly<Record<'hides' | 'wins', string>>;
  readonly relations: Readonly<Record<Relation, string>>;
  readonly lies: Readonly<Record<Event<'relation'>['relation'], string>>;
  /** The conditions that the lines of the relation test examine. */
  readonly tests: Readonly<Record<(typeof tests)[number], string>>;
  readonly becomes: Readonly<Record<Becomes, string>>;
  readonly edge: (edge: string) => string;
  readonly column: (column: string) => string;
  readonly horizons: Readonly<Record<'upper' | 'lower', string>>;
  readonly between: string;
  readonly overColumn: (column: string) => string;
  readonly inPicture: string;
  readonly hintFor: string;
  /** With the share of a point that it costs. */
  readonly hintCosts: (cost: string) => string;
  readonly hinted: Readonly<Record<Form, (entry: string) => string>>;
  readonly hintedNothing: string;
  readonly firstWrong: (entry: string) => string;
  readonly tooLong: string;
  readonly points: (points: string, most: number) => string;
  readonly check: string;
  readonly giveUp: string;
  readonly again: string;
  readonly missing: string;
  readonly verdicts: Readonly<Record<'right' | 'wrong' | 'givenUp', string>>;
  readonly partRight: string;
  readonly partWrong: string;
  readonly rightIs: (answer: string) => string;
  readonly empty: string;
  readonly because: string;
  readonly waits: (step: number) => string;
  readonly score: string;
  readonly counted: (right: number, asked: number) => string;
  readonly first: string;
  readonly earlier: (answers: number) => string;
  /** With the percentage in the course, and how many questions are left before the lesson is completed. */
  readonly kept: (percent: string, left: number) => string;
  readonly notKept: string;
  readonly name: string;
  readonly save: string;
  readonly saveHint: string;
  readonly moodle: string;
  readonly moodleHint: string;
  readonly moodleNone: string;
}
