import type { Header } from '../trace/header.js';
import type { Complaint, Ending, News, Part, Shortened } from './read.js';
import { Timeline } from './timeline.js';

/** A file that is not a trace. */
export class Unreadable extends Error implements Complaint {
  readonly line: number;
  readonly refusal: Complaint['refusal'];

  constructor({ line, refusal }: Complaint) {
    super(`line ${line}: ${refusal.path} ${refusal.reason}`);
    this.line = line;
    this.refusal = refusal;
  }
}

/** A trace that was read, or is being read and grows. */
export class Trace {
  readonly timeline: Timeline;
  shortened: Shortened | null = null;
  complete = false;
  /** The share of the file that was read, from 0 to 1. */
  read = 0;

  constructor(readonly header: Header) {
    this.timeline = new Timeline(header);
  }

  add(news: Part | Ending): void {
    if (news.is === 'part') {
      this.timeline.append(news.block);
      this.read = news.read;
    } else {
      this.shortened = news.shortened;
      this.complete = true;
    }
  }

  /** Stops waiting for the rest. */
  stop(): void {
    this.shortened = { why: 'stopped', line: this.timeline.length + 1 };
    this.complete = true;
  }

  /** Ends the run before a wrong line. */
  breakOff({ line, refusal }: Complaint): void {
    this.shortened = { why: 'wrong', line, refusal };
    this.complete = true;
  }
}

/** Assembles a trace from the reports about a file; throws `Unreadable` for a complaint. */
export function follow(trace: Trace | null, news: News): Trace | null {
  if (news.is === 'complaint') throw new Unreadable(news);
  if (news.is === 'header') return new Trace(news.header);
  trace?.add(news);
  return trace;
}

/** The same, but a wrong line does not affect the events before it. */
export function keep(trace: Trace | null, news: News): Trace | null {
  if (news.is !== 'complaint' || trace === null || trace.timeline.length === 0) {
    return follow(trace, news);
  }
  trace.breakOff(news);
  return trace;
}
