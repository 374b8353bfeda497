import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { PageTexts, Texts } from '../language/texts.js';
import type { Mark } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Target } from '../picture/target.js';
import type { Screen } from '../replay/screen.js';
import type { FloatingHorizon, Line, Values } from '../replay/values.js';
import type { Trace } from '../replay/trace.js';
import type { Event } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { ownersAt } from './owners.js';
import type { Owners } from './owners.js';

/** A step as the components show it: its event, and the states before and after it. */
export interface View {
  readonly header: Header;
  readonly step: number;
  readonly length: number;
  readonly event: Event | null;
  readonly before: Values;
  readonly after: Values;
  readonly screen: Screen;
  /** The owners of a pixel; null if it is not painted. */
  readonly ownersAt: (pixel: Pixel) => Owners | null;
  /** What a run of curves holds over each column; null in a run of polygons. */
  readonly columns: Pick<FloatingHorizon, 'horizons' | 'before' | 'flags'> | null;
  /** The lines that a run of curves has drawn. */
  readonly lines: readonly Line[];
  /** The lines of another run, shown where this run has none. */
  readonly rival?: readonly Line[];
  readonly language: Language;
  readonly texts: PageTexts;
  /** As the library makes it: what is so instead of what the run computed stands on a second line. */
  readonly sentence: string;
  /** The pixel whose history is shown; for curves, its column. */
  readonly pixel: Pixel | null;
  /** The thing that is pointed at, as elements carry it. */
  readonly pointed: string | null;
  /** The things that the current question is about, in the same form. */
  readonly asked?: readonly string[];
  /** The places in the picture that answer the current question. */
  readonly targets?: readonly Target[];
  /** The marks of the decisions worth looking at. */
  readonly found?: readonly Mark[];
  /** The marks of the reason that the reader looks at. */
  readonly explained?: readonly Mark[];
  /** Whether a lecture hall sees it, where nobody scrolls. */
  readonly hall?: boolean;
}

/** The parts of a view that the reader chooses, as opposed to those from the trace. */
export type Choice = Pick<
  View,
  'language' | 'pixel' | 'pointed' | 'asked' | 'found' | 'explained' | 'hall'
>;

export function viewOf(trace: Trace, step: number, choice: Choice): View {
  const { header, timeline } = trace;
  const { language } = choice;
  const before = timeline.valuesAt(Math.max(0, step - 1));
  const { values: after, screen } = timeline.seek(step);
  const event = timeline.event(step);
  const { page } = texts[language];
  return {
    ...choice,
    header,
    step,
    length: timeline.length,
    event,
    before,
    after,
    screen,
    ownersAt: (pixel) => ownersAt(trace, screen, pixel),
    columns: after.floatingHorizon ?? null,
    lines: after.lines ?? [],
    texts: page,
    sentence: event ? timeline.sentence(step, language) : page.start,
  };
}

/** The number format of a view's language. */
export const numbersOf = ({ language }: Pick<View, 'language'>): Texts['numbers'] =>
  texts[language].numbers;
