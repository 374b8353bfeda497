import type { Event } from './events.js';
import { Refusal } from './refusal.js';

/** Checked lines of a trace, as the original bytes in UTF-8. */
export interface Block {
  /** May have other lines before and after these. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** The start of each line in the bytes, followed by the end of the last one. */
  readonly starts: Uint32Array<ArrayBuffer>;
  /** The number of each event's name. */
  readonly names: Uint8Array<ArrayBuffer>;
}

/** The lines of a block as text. A block of ASCII is decoded as a whole, any other line by line. */
export class BlockText {
  private readonly decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
  private readonly whole: string | null;
  /** The start of the block in its bytes. */
  private readonly first: number;

  constructor(
    private readonly bytes: Uint8Array,
    private readonly starts: Uint32Array,
  ) {
    this.first = starts[0] ?? 0;
    const lines = bytes.subarray(this.first, starts.at(-1));
    const text = this.decoded(lines);
    this.whole = text?.length === lines.length ? text : null;
  }

  /** A text, and the range in it of line `i`, newline included. */
  at(i: number): readonly [text: string, start: number, end: number] {
    const start = this.starts[i] ?? 0;
    const end = this.starts[i + 1] ?? start;
    if (this.whole !== null) return [this.whole, start - this.first, end - this.first];
    const line = this.decoded(this.bytes.subarray(start, end));
    if (line === null) throw new Refusal('', 'notUtf8');
    return [line, 0, line.length];
  }

  line(i: number): string {
    const [text, start, end] = this.at(i);
    return text.slice(start, end);
  }

  private decoded(bytes: Uint8Array): string | null {
    try {
      return this.decoder.decode(bytes);
    } catch {
      return null;
    }
  }
}

/** No text within a line contains this, because its quotes would be escaped. */
const depths = ',"depths":[';
const opening = '['.charCodeAt(0);
const closing = ']'.charCodeAt(0);
const comma = ','.charCodeAt(0);
/** The depths of a line begin within this number of bytes. */
const longestHead = 1024;
const latin = new TextDecoder('latin1');
const utf8 = new TextDecoder();

/** Bytes as text; null if one is not ASCII. */
function asciiOf(bytes: Uint8Array): string | null {
  const text = latin.decode(bytes);
  // eslint-disable-next-line no-control-regex
  return /^[\x00-\x7f]*$/.test(text) ? text : null;
}

interface Stored extends Block {
  /** The number of events before the block, and the bytes of their lines. */
  readonly before: number;
  readonly bytesBefore: number;
}

const sizeOf = ({ starts }: Block): number => (starts.at(-1) ?? 0) - (starts[0] ?? 0);

/**
 * The events of a trace. Each is stored as its original line, and parsed on request: a million events are a few large
 * arrays. The store grows at its end by blocks from any source.
 */
export class Store {
  private readonly blocks: Stored[] = [];
  private column = new Uint8Array(1024);
  private count = 0;
  /** The bytes of all lines. */
  private size = 0;
  private open: { readonly block: Stored; readonly text: BlockText } | null = null;
  private last: { readonly step: number; readonly event: Event } | null = null;

  get length(): number {
    return this.count;
  }

  /** The numbers of the events' names; that of step n is at n - 1. Passes over a long run use these first. */
  get names(): Uint8Array {
    return this.column.subarray(0, this.count);
  }

  append(block: Block): void {
    if (block.names.length === 0) return;
    this.blocks.push({ ...block, before: this.count, bytesBefore: this.size });
    this.size += sizeOf(block);
    const end = this.count + block.names.length;
    if (end > this.column.length) {
      const larger = new Uint8Array(Math.max(end, 2 * this.column.length));
      larger.set(this.names);
      this.column = larger;
    }
    this.column.set(block.names, this.count);
    this.count = end;
  }

  /** The event of a step, from 1. */
  event(step: number): Event | null {
    if (step < 1 || step > this.count) return null;
    if (this.last?.step !== step) {
      this.last = { step, event: JSON.parse(this.line(step)) as Event };
    }
    return this.last.event;
  }

  /** The same for an event far from other requested ones: decodes only its own line. */
  eventAlone(step: number): Event | null {
    if (step < 1 || step > this.count) return null;
    if (this.last?.step === step || (this.open !== null && isIn(this.open.block, step))) {
      return this.event(step);
    }
    return JSON.parse(utf8.decode(lineIn(this.find(step), step))) as Event;
  }

  /** The events of some steps, far from other requested ones: decodes and parses their lines alone, all at once. */
  eventsAlone(steps: readonly number[]): readonly Event[] {
    let block: Stored | null = null;
    let size = 1;
    const lines: Uint8Array[] = [];
    for (const step of steps) {
      if (block === null || !isIn(block, step)) block = this.find(step);
      const line = lineIn(block, step);
      lines.push(line);
      size += 1 + line.length;
    }
    const list = new Uint8Array(Math.max(size, 2));
    let end = 0;
    for (const line of lines) {
      list[end] = comma;
      list.set(line, end + 1);
      end += 1 + line.length;
    }
    list[0] = opening;
    list[list.length - 1] = closing;
    return JSON.parse(utf8.decode(list)) as Event[];
  }

  /** The same without the depths of its pixels, which may be most of a long line and are not decoded. */
  eventWithoutDepths(step: number): Event | null {
    if (step < 1 || step > this.count) return null;
    const { bytes, starts, before } = this.find(step);
    const [start = 0, end = 0] = starts.subarray(step - 1 - before);
    const head = asciiOf(bytes.subarray(start, Math.min(start + longestHead, end)));
    const at = head?.indexOf(depths) ?? -1;
    if (head === null || at < 0) return this.event(step);
    const rest = asciiOf(bytes.subarray(bytes.indexOf(closing, start + at) + 1, end));
    return rest === null ? this.event(step) : (JSON.parse(head.slice(0, at) + rest) as Event);
  }

  /** The number of bytes in the lines of the first steps. */
  bytesBefore(steps: number): number {
    if (steps >= this.count) return this.size;
    const { starts, before, bytesBefore } = this.find(steps + 1);
    return bytesBefore + (starts[steps - before] ?? 0) - (starts[0] ?? 0);
  }

  /** The last step up to which the lines have at most the given number of bytes. */
  stepAt(bytes: number): number {
    let from = 0;
    let end = this.count + 1;
    while (end - from > 1) {
      const middle = (from + end) >> 1;
      if (this.bytesBefore(middle) <= bytes) from = middle;
      else end = middle;
    }
    return from;
  }

  /** The last step in the block of a step: steps beyond it need another block to be decoded. */
  endOfBlock(step: number): number {
    const { before, names } = this.find(step);
    return before + names.length;
  }

  /** The text of a step's line. */
  line(step: number): string {
    const { block, text } = this.blockOf(step);
    return text.line(step - 1 - block.before);
  }

  /** Keeps the text of the block requested last, because neighbouring steps are requested in succession. */
  private blockOf(step: number): { readonly block: Stored; readonly text: BlockText } {
    const { open } = this;
    if (open !== null && isIn(open.block, step)) return open;
    const block = this.find(step);
    this.open = { block, text: new BlockText(block.bytes, block.starts) };
    return this.open;
  }

  private find(step: number): Stored {
    let from = 0;
    let end = this.blocks.length;
    while (end - from > 1) {
      const middle = (from + end) >> 1;
      if ((this.blocks[middle]?.before ?? Infinity) < step) from = middle;
      else end = middle;
    }
    const block = this.blocks[from];
    if (block === undefined) throw new RangeError(`step ${step} of ${this.count}`);
    return block;
  }
}

/** The bytes of a step's line. */
function lineIn({ bytes, starts, before }: Stored, step: number): Uint8Array {
  return bytes.subarray(starts[step - 1 - before], starts[step - before]);
}

function isIn({ before, names }: Stored, step: number): boolean {
  return step > before && step <= before + names.length;
}
