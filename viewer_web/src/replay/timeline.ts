import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import type { SaidDecision } from '../trace/event-table.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { engine } from './engine.js';
import { Screen } from './screen.js';
import type { Division } from './screen.js';
import { ValueReader } from './values.js';
import type { Line, Values } from './values.js';

/** How a run compares with exact arithmetic, in the library's order: the number of wrong pixels, or steps of curves. */
export type Comparison =
  { readonly is: 'unknown' | 'awaited' } | { readonly is: 'known'; readonly wrong: number };
const comparisons = ['unknown', 'awaited', 'known'] as const satisfies readonly Comparison['is'][];

/** The state after a step. */
export interface State {
  readonly values: Values;
  /** The pixels, also after other steps were looked at. A run of curves has none. */
  readonly screen: Screen;
}

const forgotten = new FinalizationRegistry((trace: number) => engine().exports.trace_close(trace));

/** The steps of a trace, which the library holds and which may grow at its end. */
export class Timeline {
  private column = new Uint8Array(0);
  private readonly values = new ValueReader();
  private readonly division: Division = { of: '', windows: [] };
  private last: { readonly step: number; readonly event: Event } | null = null;

  constructor(
    private readonly trace: number,
    private readonly header: Header,
  ) {
    // Screens outlive their timeline, and hold this.
    forgotten.register(this.values, trace);
  }

  get length(): number {
    return this.column.length;
  }

  /** The numbers of the events' names, for passes over a long run without its events. That of step n is at n - 1. */
  get names(): Uint8Array {
    return this.column;
  }

  /** Looks for further steps. */
  grow(): void {
    const { exports } = engine();
    const length = exports.trace_length(this.trace);
    this.column = engine().bytes(exports.trace_names(this.trace), length).slice();
  }

  /** The event of a step, from 1; null beyond the steps. */
  event(step: number): Event | null {
    if (step < 1 || step > this.length) return null;
    if (this.last?.step !== step) {
      this.last = { step, event: JSON.parse(this.line(step)) as Event };
    }
    return this.last.event;
  }

  /** The text of a step's event as it was read. */
  line(step: number): string {
    engine().exports.trace_line(this.trace, step);
    return engine().made();
  }

  /** One sentence that says what a step does. */
  sentence(step: number, language: Language): string {
    engine().exports.trace_sentence(this.trace, step, languages.indexOf(language));
    return engine().made();
  }

  /** What the event of a step found, in the notation of the listing; empty if it has no note. */
  note(step: number, language: Language): string {
    engine().exports.trace_note(this.trace, step, languages.indexOf(language));
    return engine().made();
  }

  /** The notes beside the listing at a step, by the labels of lines. */
  notesAt(step: number, language: Language): ReadonlyMap<string, string> {
    engine().exports.trace_notes(this.trace, step, languages.indexOf(language));
    return new Map(JSON.parse(engine().made()) as readonly (readonly [string, string])[]);
  }

  /** The decision of a step in words; null if it decides nothing. */
  decision(step: number, language: Language): SaidDecision | null {
    engine().exports.trace_decision(this.trace, step, languages.indexOf(language));
    const made = engine().made();
    return made === '' ? null : (JSON.parse(made) as SaidDecision);
  }

  /** The verdict on the run at its end. */
  verdict(comparison: Comparison, language: Language): string {
    const wrong = comparison.is === 'known' ? comparison.wrong : 0;
    const is = comparisons.indexOf(comparison.is);
    engine().exports.trace_verdict(this.trace, is, wrong, languages.indexOf(language));
    return engine().made();
  }

  /** The state after the first `step` events. */
  seek(step: number): State {
    const { header, values, trace, division } = this;
    const screen = new Screen(header, trace, () => values.goTo(trace, step), division);
    return { values: values.at(trace, step), screen };
  }

  /** The lines that a run of curves has drawn after a step. */
  linesAt(step: number): readonly Line[] {
    return this.valuesAt(step).lines ?? [];
  }

  /** The values after the first `step` events. */
  valuesAt(step: number): Values {
    return this.values.at(this.trace, step);
  }
}
