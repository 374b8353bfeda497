import { parseHeader } from '../trace/header.js';
import type { Header } from '../trace/header.js';
import { Lines } from '../trace/lines.js';
import { parseJson, parseLine } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import { Refusal, isRefusal } from '../trace/refusal.js';
import { BlockText } from '../trace/store.js';
import type { Block } from '../trace/store.js';
import { QuickRun } from './quick-run.js';
import { Run } from './run.js';

/** A file for a worker to read, and the library for quick reading. */
export interface Order {
  readonly file: Blob;
  readonly library: WebAssembly.Module | null;
}

/** The error in a file that is not a trace, or not up to its end: the line, from 1, and the reason. */
export interface Complaint {
  readonly line: number;
  readonly refusal: Pick<Refusal, 'path' | 'reason' | 'details'>;
}

/** The file is truncated, the run was stopped, it is too long for a page, or the reader stopped reading it. */
export interface Ended {
  readonly why: 'cut' | 'partial' | 'limit' | 'stopped';
  readonly line: number;
}

/** Why the trace is shorter than the run, or than its file with a wrong line. */
export type Shortened = Ended | ({ readonly why: 'wrong' } & Complaint);

/** Further events, each checked to be possible at its place. */
export interface Part {
  readonly is: 'part';
  readonly block: Block;
  /** The share of the file that was read, from 0 to 1. */
  readonly read: number;
}

export interface Ending {
  readonly is: 'end';
  readonly end: End | null;
  readonly shortened: Ended | null;
}

/**
 * The results of reading a file, as plain data: first the header, then parts, then the end; or a complaint, which is the
 * last.
 */
export type News =
  | { readonly is: 'header'; readonly header: Header }
  | Part
  | Ending
  | ({ readonly is: 'complaint' } & Complaint);

const mostBytes = 2 ** 30;
const newline = 10;
const ending = '{"end":';

function lineStarts(bytes: Uint8Array, from: number): Uint32Array<ArrayBuffer> {
  const starts = [from];
  for (let at = bytes.indexOf(newline, from); at >= 0; at = bytes.indexOf(newline, at + 1)) {
    starts.push(at + 1);
  }
  if (starts.at(-1) !== bytes.length) starts.push(bytes.length);
  return Uint32Array.from(starts);
}

/** A line that the library leaves to `Run`, which must have read all lines before it. */
class NotQuick extends Error {}

class Reader {
  line = 0;
  header: Header | null = null;
  shortened: Ended | null = null;
  /** Why a line does not belong to a trace; the lines before it remain valid. */
  refusal: Refusal | null = null;
  private events = 0;
  private run: Run | QuickRun | null = null;
  private end: End | null = null;

  constructor(private readonly library: WebAssembly.Module | null) {}

  /**
   * The events of a block of lines. Only the last line may lack its newline, because a line may be split between blocks.
   */
  take(bytes: Uint8Array<ArrayBuffer>): Block {
    const from = this.header === null ? this.takeFirst(bytes) : 0;
    if (!(this.run instanceof QuickRun)) return this.takeLines(bytes, from);
    const { starts, names } = this.run.take(bytes.subarray(from));
    this.line += names.length;
    this.events += names.length;
    const rest = from + (starts.at(-1) ?? 0);
    if (rest < bytes.length) this.takeLines(bytes, rest);
    return { bytes, starts: from === 0 ? starts : starts.map((start) => from + start), names };
  }

  shorten(why: Ended['why']): void {
    this.shortened ??= { why, line: this.line };
  }

  ending(): Ending {
    if (this.header === null) throw new Refusal('', 'emptyFile');
    if (this.end === null) this.shorten('cut');
    return { is: 'end', end: this.end, shortened: this.shortened };
  }

  /** The start of the second line. */
  private takeFirst(bytes: Uint8Array): number {
    this.line++;
    const end = bytes.indexOf(newline) + 1 || bytes.length;
    const text = new BlockText(bytes, Uint32Array.of(0, end));
    this.header = parseHeader(parseJson(text.line(0), 'emptyLine'));
    const { library, header } = this;
    const quick = library && QuickRun.of(library, bytes.subarray(0, end), header);
    this.run = quick ?? new Run(header);
    return end;
  }

  private takeLines(bytes: Uint8Array<ArrayBuffer>, from: number): Block {
    const starts = lineStarts(bytes, from);
    const text = new BlockText(bytes, starts);
    const names = new Uint8Array(starts.length - 1);
    let count = 0;
    for (let i = 0; i < starts.length - 1; i++) {
      this.line++;
      if (bytes[(starts[i + 1] ?? 0) - 1] !== newline && !isJson(text, i)) {
        this.shorten('cut');
        break;
      }
      const name = this.tryLine(text, i);
      if (this.refusal !== null) break;
      if (name !== null) names[count++] = name;
    }
    return { bytes, starts: starts.slice(0, count + 1), names: names.slice(0, count) };
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

  /** The number of the event's name; null for the last line. */
  private takeLine(text: BlockText, i: number): number | null {
    if (this.end !== null) throw new Refusal('', 'afterEnd');
    const found = this.run instanceof Run ? this.run.take(text, i) : this.endOn(text.line(i));
    if (typeof found !== 'number') {
      this.finish(found);
      return null;
    }
    this.events++;
    return found;
  }

  /** The end that the last line states. Any other line is left to `Run`. */
  private endOn(text: string): End {
    if (this.header === null || !text.startsWith(ending)) throw new NotQuick();
    const found = parseLine(text, this.header);
    if (!('end' in found)) throw new NotQuick();
    return found.end;
  }

  private finish(end: End): void {
    const { events } = this;
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
    const block = reader.take(text);
    if (!known && reader.header !== null) yield { is: 'header', header: reader.header };
    if (reader.header !== null) yield { is: 'part', block, read: lines.read / file.size };
    if (reader.refusal !== null) throw reader.refusal;
  }
  refuseBreak(lines, reader);
  yield reader.ending();
}

/** Reports the results of a reader, including complaints. */
async function* readBy(reader: Reader, file: Blob, most: number): AsyncGenerator<News> {
  try {
    yield* readInto(reader, file, most);
  } catch (error) {
    if (!isRefusal(error)) throw error;
    const { path, reason, details } = error;
    yield { is: 'complaint', line: Math.max(1, reader.line), refusal: { path, reason, details } };
  }
}

/** How to read: the most unpacked bytes, and the library if there is one. */
export interface Way {
  readonly most?: number | undefined;
  readonly library?: WebAssembly.Module | null;
}

/**
 * Reads a trace, plain or gzip. If the library leaves a line to `Run`, the file is read again, and only new results are
 * reported.
 */
export async function* read(
  file: Blob,
  { most = mostBytes, library = null }: Way = {},
): AsyncGenerator<News> {
  let told = 0;
  try {
    for await (const news of readBy(new Reader(library), file, most)) {
      told++;
      yield news;
    }
    return;
  } catch (error) {
    if (!(error instanceof NotQuick)) throw error;
  }
  for await (const news of readBy(new Reader(null), file, most)) {
    if (told-- <= 0) yield news;
  }
}
