import { Timeline } from '../state/timeline.js';
import { parseHeader } from './header.js';
import type { Header } from './header.js';
import { Lines } from './lines.js';
import { parseJson, parseLine } from './parse.js';
import type { End } from './parse.js';
import { Refusal, isRefusal } from './refusal.js';

/** The trace is shorter than the run: the file broke off, the run was stopped, or it is too long for a page. */
export interface Shortened {
  readonly why: 'cut' | 'partial' | 'limit';
  readonly line: number;
}

/** A trace that was read, each of its events applied once. */
export interface Trace {
  readonly header: Header;
  readonly timeline: Timeline;
  readonly end: End | null;
  readonly shortened: Shortened | null;
}

/** A file that is no trace: the line, from 1, and the reason. */
export class Unreadable extends Error {
  constructor(
    readonly line: number,
    readonly refusal: Refusal,
  ) {
    super(`line ${line}: ${refusal.message}`);
  }
}

const mostEvents = 4_000_000;

class Reader {
  line = 0;
  shortened: Shortened | null = null;
  private header: Header | null = null;
  private timeline: Timeline | null = null;
  private end: End | null = null;

  take(text: string): void {
    this.line++;
    if (this.header === null || this.timeline === null) {
      this.header = parseHeader(parseJson(text));
      this.timeline = new Timeline(this.header);
      return;
    }
    if (this.end !== null) throw new Refusal('', 'afterEnd');
    const found = parseLine(text, this.header);
    if ('event' in found) this.timeline.append(found.event);
    else this.finish(found.end, this.timeline.length);
    if (this.timeline.length >= mostEvents) this.shorten('limit');
  }

  /** A last line without its newline may be cut in two. */
  takeLast(text: string): void {
    try {
      parseJson(text);
    } catch {
      this.line++;
      this.shorten('cut');
      return;
    }
    this.take(text);
  }

  shorten(why: Shortened['why']): void {
    this.shortened ??= { why, line: this.line };
  }

  result(): Trace {
    const { header, timeline, end } = this;
    if (header === null || timeline === null) throw new Refusal('', 'empty');
    if (end === null) this.shorten('cut');
    return { header, timeline, end, shortened: this.shortened };
  }

  private finish(end: End, events: number): void {
    if (end.events !== events) {
      throw new Refusal('end.events', 'eventCount', String(end.events), String(events));
    }
    this.end = end;
    if (end.partial === true) this.shorten('partial');
  }
}

function refuseBreak(lines: Lines, reader: Reader): void {
  const why = lines.broken?.why;
  if (why === 'utf8') throw new Refusal('', 'notUtf8');
  if (why === 'long') throw new Refusal('', 'longLine');
  if (why === 'gzip' && reader.line === 0) throw new Refusal('', 'notGzip');
}

async function readInto(reader: Reader, lines: Lines): Promise<Trace> {
  for await (const { lines: batch, whole } of lines.batches()) {
    for (const line of batch) {
      if (whole) reader.take(line);
      else reader.takeLast(line);
      if (reader.shortened?.why === 'limit') return reader.result();
    }
  }
  refuseBreak(lines, reader);
  return reader.result();
}

/** Reads a trace, plain or gzip; what is wrong with it is an `Unreadable` with line and reason. */
export async function readTrace(file: Blob): Promise<Trace> {
  const reader = new Reader();
  try {
    return await readInto(reader, new Lines(file));
  } catch (error) {
    if (isRefusal(error)) throw new Unreadable(Math.max(1, reader.line), error);
    throw error;
  }
}
