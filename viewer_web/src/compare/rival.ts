import type { Quick } from '../language/texts.js';
import { embeddedFile, embeddedLessons, idOf } from '../lessons/lessons.js';
import type { LessonTrace } from '../lessons/lessons.js';
import { openTrace } from '../replay/open.js';
import type { Trace } from '../replay/trace.js';
import { noticeOf } from '../run/notice.js';
import type { Notice } from '../run/notice.js';
import type { Options } from '../run/options.js';
import { editionsOf, runnable, runs } from '../run/options.js';
import { optionsOf, wordOf } from '../run/packed.js';
import { sceneText } from '../run/sketch.js';
import { Tracer } from '../run/tracer.js';
import { drawsCurves, eventsOf } from '../trace/events.js';
import type { Method } from '../trace/events.js';
import type { Scene } from '../trace/header.js';

/**
 * What to compare a run with: another run of its scene, another scene, the run before the last change, a lesson's trace, or
 * a file.
 */
export type With =
  | { readonly kind: 'run'; readonly options: Options }
  | {
      readonly kind: 'other';
      readonly options: Options;
      readonly scene: string;
      /** The word that denotes it in an address. */
      readonly word: string;
    }
  | { readonly kind: 'before'; readonly trace: Trace }
  | { readonly kind: 'lesson'; readonly lesson: LessonTrace }
  | { readonly kind: 'file'; readonly file: File };

/** What a word in an address denotes: the id of an embedded trace, or how to run the scene. */
export function withOf(word: string, page: Document): With | null {
  const traces = embeddedLessons(page).flatMap((lesson) => lesson.traces);
  const lesson = traces.find((each) => idOf(each) === word);
  if (lesson !== undefined) return { kind: 'lesson', lesson };
  const [method = ''] = word.split('.');
  return Object.hasOwn(eventsOf, method) ? { kind: 'run', options: optionsOf(word) } : null;
}

/** The run beside the open one, if there is one. */
export class Rival {
  trace: Trace | null = null;
  /** The number of its steps read so far. */
  steps = 0;
  notice: Notice | null = null;
  chosen: With | null = null;
  private readonly tracer: Tracer | null;
  /** The scene of the open run, and the text of the last scene run here. */
  private scene: Scene | null = null;
  private ran = '';
  private stopReading = (): void => undefined;

  constructor(
    library: Blob | null,
    private readonly changed: () => void,
  ) {
    const take = (trace: Trace | null, messages: string): void => {
      if (this.chosen?.kind !== 'run' && this.chosen?.kind !== 'other') return;
      if (trace === null) this.say({ kind: 'refused', name: this.name, messages });
      else this.show(trace);
    };
    const fail = (error: unknown): void => this.say({ kind: 'failed', name: this.name, error });
    this.tracer = library && new Tracer(library, (made) => take(made.trace, made.messages), fail);
  }

  /** The word that denotes it in an address. */
  get word(): string | null {
    const { chosen } = this;
    if (chosen?.kind === 'run') return wordOf(chosen.options);
    if (chosen?.kind === 'other') return chosen.word;
    return chosen?.kind === 'lesson' ? idOf(chosen.lesson) : null;
  }

  private get name(): string {
    return this.scene?.name ?? '';
  }

  choose(chosen: With | null): void {
    this.stopReading();
    this.tracer?.forget();
    this.trace = null;
    this.notice = null;
    this.ran = '';
    this.chosen = chosen;
    if (chosen?.kind === 'run') this.run();
    else if (chosen?.kind === 'other') this.tracer?.run(chosen.scene, chosen.options);
    else if (chosen?.kind === 'before') this.show(chosen.trace);
    else if (chosen?.kind === 'file') this.open(chosen.file, chosen.file.name);
    else if (chosen?.kind === 'lesson') {
      const file = embeddedFile(document, chosen.lesson.file);
      if (file !== null) this.open(file, chosen.lesson.file);
    }
    this.changed();
  }

  /** Stops reading the file and keeps the steps read so far. */
  stop(): void {
    this.stopReading();
    this.trace?.end('stopped');
    if (this.trace === null) this.choose(null);
    else this.show(this.trace);
  }

  /** Runs the open scene again with the other settings when it has changed. */
  follow(scene: Scene): void {
    this.scene = scene;
    if (this.chosen?.kind === 'run') this.run();
  }

  private run(): void {
    const { scene, chosen } = this;
    if (scene === null || chosen?.kind !== 'run') return;
    const text = sceneText(scene);
    if (text === this.ran) return;
    this.ran = text;
    this.tracer?.run(text, chosen.options);
  }

  private open(file: Blob, name: string): void {
    this.notice = { kind: 'reading', name };
    const failed = (error: unknown): void => {
      this.chosen = null;
      this.trace = null;
      this.say({ kind: 'failed', name, error });
    };
    this.stopReading = openTrace(file, { grown: (trace) => this.show(trace), failed });
  }

  private show(trace: Trace): void {
    this.trace = trace;
    this.steps = trace.timeline.length;
    this.say(trace.complete ? noticeOf(trace) : null);
  }

  private say(notice: Notice | null): void {
    this.notice = notice;
    this.changed();
  }
}

/** The other methods for the scene; curves have a single method. */
function otherMethods(method: Method): readonly Method[] {
  if (drawsCurves(method)) return [];
  return [method === 'warnock' ? 'zbuffer' : 'warnock'];
}

/** The settings with which a run is most often compared. */
export function quickRuns(options: Options): readonly (readonly [Quick, Options])[] {
  const { method, edition, kernel } = options;
  const variants: readonly Method[] = method === 'warnock' ? ['warnock-full'] : [];
  const otherEdition = edition === 'corrected' ? 'printed' : 'corrected';
  const editions = editionsOf(method).includes(otherEdition) ? ([otherEdition] as const) : [];
  const kernels = (['exact', 'float'] as const).filter(
    (each) => each !== kernel && runs({ ...options, kernel: each }),
  );
  return [
    ...otherMethods(method).map(
      (other) => ['method', runnable({ ...options, method: other })] as const,
    ),
    ...variants.map((each) => ['variant', runnable({ ...options, method: each })] as const),
    ...editions.map((each) => [each, runnable({ ...options, edition: each })] as const),
    ...kernels.map((each) => [each, { ...options, kernel: each }] as const),
  ];
}
