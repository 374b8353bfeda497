/** The texts around the text of a lesson. */
export interface ReaderTexts {
  readonly text: string;
  readonly hide: string;
  readonly contents: string;
  readonly follow: string;
  readonly followHint: string;
  readonly step: (step: number) => string;
  readonly pin: (step: number, run: string) => string;
  readonly linkHere: (heading: string) => string;
  /** The name of the part that states the time, what comes first, the terms and the goals. */
  readonly about: string;
  readonly time: string;
  readonly minutes: (minutes: number) => string;
  readonly prerequisites: string;
  readonly noPrerequisites: string;
  readonly terms: string;
  readonly goals: string;
  readonly sources: string;
  readonly chapter: (chapter: string) => string;
  readonly question: (number: number) => string;
  readonly exercise: (number: number) => string;
  readonly answer: string;
  readonly answers: string;
  readonly copy: string;
  readonly copied: string;
  readonly previous: string;
  readonly next: string;
  readonly otherLessons: string;
  readonly runs: string;
  readonly refused: (where: string, reason: string) => string;
  readonly broken: string;
}
