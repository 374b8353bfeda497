import type { Keyframe } from './state.js';
import { parseHeader } from '../trace/header.js';
import type { Header } from '../trace/header.js';
import { Lines } from '../trace/lines.js';
import { parseJson } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import { Refusal, isRefusal } from '../trace/refusal.js';
import { Run } from './run.js';
import { BlockText } from '../trace/store.js';
import type { Block } from '../trace/store.js';

/** What is wrong with a file that is no trace, or no longer one: the line, from 1, and the reason. */
export interface Complaint {
  readonly line: number;
  readonly refusal: Pick<Refusal, 'path' | 'reason' | 'details'>;
}

/** The file broke off, the run was stopped, or it is too long for a page. */
export interface Ended {
  readonly why: 'cut' | 'partial' | 'limit';
  readonly line: number;
}

/** The trace is shorter than the run, or than its file, of which a line is wrong. */
export type Shortened = Ended | ({ readonly why: 'wrong' } & Complaint);

/** Further events, each of them checked and applied once, and the keyframes among them. */
export interface Part {
  readonly is: 'part';
  readonly block: Block;
  readonly keyframes: readonly Keyframe[];
  /** How much of the file was read, from 0 to 1. */
  readonly read: number;
}

export interface Ending {
  readonly is: 'end';
  readonly end: End | null;
  readonly shortened: Ended | null;
}

/** What is found in a file, as plain data: first the header, then parts, then the end; or a complaint, the last. */
export type News =
  | { readonly is: 'header'; readonly header: Header }
  | Part
  | Ending
  | ({ readonly is: 'complaint' } & Complaint);

const mostBytes = 2 ** 30;
const newline = 10;

function lineStarts(bytes: Uint8Array): Uint32Array<ArrayBuffer> {
  const starts = [0];
  for (let at = bytes.indexOf(newline); at >= 0; at = bytes.indexOf(newline, at + 1)) {
    starts.push(at + 1);
  }
  if (starts.at(-1) !== bytes.length) starts.push(bytes.length);
  return Uint32Array.from(starts);
}

class Reader {
  line = 0;
  header: Header | null = null;
  shortened: Ended | null = null;
  /** Why a line is none of a trace; the lines before it stand. */
  refusal: Refusal | null = null;
  private run: Run | null = null;
  private end: End | null = null;

  /** The events of a block of lines; only the last may lack its newline, as it may be cut in two. */
  take(bytes: Uint8Array<ArrayBuffer>): Omit<Part, 'is' | 'read'> {
    const starts = lineStarts(bytes);
    const text = new BlockText(bytes, starts);
    const first = this.header === null ? 1 : 0;
    const names = new Uint8Array(starts.length - 1);
    let count = 0;
    for (let i = 0; i < starts.length - 1; i++) {
      this.line++;
      const isCut = bytes[(starts[i + 1] ?? 0) - 1] !== newline && !isJson(text, i);
      if (isCut && this.header !== null) {
        this.shorten('cut');
        break;
      }
      const name = this.tryLine(text, i);
      if (this.refusal !== null) break;
      if (name !== null) names[count++] = name;
    }
    return {
      block: {
        bytes,
        starts: starts.slice(first, first + count + 1),
        names: names.slice(0, count),
      },
      keyframes: this.run?.takeKeyframes() ?? [],
    };
  }

  shorten(why: Ended['why']): void {
    this.shortened ??= { why, line: this.line };
  }

  ending(): Ending {
    if (this.header === null) throw new Refusal('', 'emptyFile');
    if (this.end === null) this.shorten('cut');
    return { is: 'end', end: this.end, shortened: this.shortened };
  }

  private tryLine(text: BlockText, i: number): number | null {
    try {
      return this.takeLine(text, i);
    } catch (error) {
      if (!isRefusal(error)) throw error;
      this.refusal = error;
      return null;
    }
  }

  /** The number of the event's name, or null for the first line and the last. */
  private takeLine(text: BlockText, i: number): number | null {
    if (this.run === null) {
      this.header = parseHeader(parseJson(text.line(i), 'emptyLine'));
      this.run = new Run(this.header);
      return null;
    }
    if (this.end !== null) throw new Refusal('', 'afterEnd');
    const found = this.run.take(text, i);
    if (typeof found === 'number') return found;
    this.finish(found, this.run.length);
    return null;
  }

  private finish(end: End, events: number): void {
    if (end.events !== events) {
      throw new Refusal('end.events', 'eventCount', String(end.events), String(events));
    }
    this.end = end;
    if (end.partial === true) this.shorten('partial');
  }
}

function isJson(text: BlockText, line: number): boolean {
  try {
    parseJson(text.line(line), 'emptyLine');
    return true;
  } catch {
    return false;
  }
}

function refuseBreak({ broken }: Lines, reader: Reader): void {
  if (broken === 'long') throw new Refusal('', 'longLine');
  if (broken === 'gzip' && reader.line === 0) throw new Refusal('', 'notGzip');
}

async function* readInto(reader: Reader, file: Blob, most: number): AsyncGenerator<News> {
  const lines = new Lines(file);
  let bytes = 0;
  for await (const text of lines.blocks()) {
    bytes += text.length;
    if (bytes > most) {
      reader.shorten('limit');
      break;
    }
    const known = reader.header !== null;
    const part = reader.take(text);
    if (!known && reader.header !== null) yield { is: 'header', header: reader.header };
    if (reader.header !== null) yield { is: 'part', ...part, read: lines.read / file.size };
    if (reader.refusal !== null) throw reader.refusal;
  }
  refuseBreak(lines, reader);
  yield reader.ending();
}

/** Reads a trace, plain or gzip, of at most so many bytes when unpacked. */
export async function* read(file: Blob, most = mostBytes): AsyncGenerator<News> {
  const reader = new Reader();
  try {
    yield* readInto(reader, file, most);
  } catch (error) {
    if (!isRefusal(error)) throw error;
    const { path, reason, details } = error;
    yield { is: 'complaint', line: Math.max(1, reader.line), refusal: { path, reason, details } };
  }
}
