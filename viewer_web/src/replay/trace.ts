import { headerOf } from '../trace/header.js';
import type { Header } from '../trace/header.js';
import { engine } from './engine.js';
import { Timeline } from './timeline.js';

/** What is wrong with a line of a file: the place in the line and the reason, in the library's words. */
export interface Complaint {
  readonly line: number;
  readonly path: string;
  readonly reason: string;
}

/** The file is truncated, the run was stopped, it is too long for a page, or the reader stopped reading it. */
export interface Ended {
  readonly why: 'cut' | 'partial' | 'limit' | 'stopped';
  /** The last line that was read. */
  readonly line: number;
}

/** Why the trace is shorter than the run, or than its file with a wrong line. */
export type Shortened = Ended | ({ readonly why: 'wrong' } & Complaint);

/** Why it is shorter, as the library says it. */
interface ShortenedByLibrary {
  readonly why: 'cut' | 'partial' | 'wrong';
  readonly line: number;
  readonly reason: string;
}

/** A file that is not a trace. */
export class Unreadable extends Error implements Complaint {
  constructor(
    readonly reason: string,
    readonly path = '',
    readonly line = 1,
  ) {
    super(`line ${line}: ${path} ${reason}`);
  }
}

/** The library's reason, "/path: reason" or a reason alone. */
function placed(text: string): Pick<Complaint, 'path' | 'reason'> {
  const [, path = '', reason = text] = /^(\/\S*): (.*)$/su.exec(text) ?? [];
  return { path, reason };
}

/** A trace that is read piece by piece. Its trace exists once its first line was read. */
export class Opening {
  trace: Trace | null = null;
  private readonly number = engine().exports.trace_open();

  /** Throws Unreadable if the file is not a trace. */
  append(bytes: Uint8Array): void {
    engine().ask(bytes);
    this.expect(engine().exports.trace_append(this.number));
  }

  /** The file has ended. Throws Unreadable if it is not a trace. */
  finish(): Trace {
    this.expect(engine().exports.trace_finish(this.number));
    return this.broken();
  }

  /** The trace as far as it was read. Throws Unreadable if its first event is wrong: then there is no run. */
  broken(): Trace {
    const { trace } = this;
    if (trace === null) throw new Error('a trace without a header');
    const { shortened, timeline } = trace;
    if (shortened?.why === 'wrong' && timeline.length === 0) {
      throw new Unreadable(shortened.reason, shortened.path, shortened.line);
    }
    trace.complete = true;
    return trace;
  }

  private expect(isRead: number): void {
    if (isRead === 0) {
      const { path, reason } = placed(engine().messages());
      throw new Unreadable(reason, path);
    }
    this.trace ??= this.begun();
    this.trace?.grow();
  }

  private begun(): Trace | null {
    engine().exports.trace_header(this.number);
    const header = engine().made();
    return header === '' ? null : new Trace(this.number, headerOf(header));
  }
}

/** A trace that was read, or is being read and grows. */
export class Trace {
  readonly timeline: Timeline;
  shortened: Shortened | null = null;
  complete = false;
  /** The share of the file that was read, from 0 to 1. */
  read = 0;

  constructor(
    readonly number: number,
    readonly header: Header,
  ) {
    this.timeline = new Timeline(number, header);
  }

  /** Looks for what was read meanwhile. */
  grow(): void {
    this.timeline.grow();
    engine().exports.trace_shortened(this.number);
    const made = engine().made();
    if (made === '') return;
    const { why, line, reason } = JSON.parse(made) as ShortenedByLibrary;
    this.shortened =
      why === 'wrong' ? { why, line, ...placed(reason) } : { why, line: this.timeline.length + 1 };
  }

  /** Ends the reading here: the reader stopped it, or the file is too long. */
  end(why: 'stopped' | 'limit'): void {
    this.shortened = { why, line: this.timeline.length + 1 };
    this.complete = true;
  }
}

/** A trace whose bytes are all here. */
export function traceOf(bytes: Uint8Array): Trace {
  const opening = new Opening();
  opening.append(bytes);
  return opening.finish();
}
