import type { Event } from './events.js';
import { Refusal } from './refusal.js';

/** Lines of a trace in the bytes that they came in, UTF-8, all of them checked. */
export interface Block {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Where each line begins, and where the last one ends. */
  readonly starts: Uint32Array<ArrayBuffer>;
  /** The number of each event's name. */
  readonly names: Uint8Array<ArrayBuffer>;
}

/** The lines of a block as text: decoded together where each byte is a character, one by one elsewhere. */
export class BlockText {
  private readonly decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
  private readonly whole: string | null;

  constructor(
    private readonly bytes: Uint8Array,
    private readonly starts: Uint32Array,
  ) {
    const text = this.decoded(bytes);
    this.whole = text?.length === bytes.length ? text : null;
  }

  /** A text, and from where to where in it line `i` is, newline included. */
  at(i: number): readonly [text: string, start: number, end: number] {
    const start = this.starts[i] ?? 0;
    const end = this.starts[i + 1] ?? start;
    if (this.whole !== null) return [this.whole, start, end];
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

/** No text within a line has this: its quotes would be escaped. */
const depths = ',"depths":[';

interface Stored extends Block {
  /** How many events come before the block. */
  readonly before: number;
}

/**
 * The events of a trace, each kept as the line that it came in and parsed when it is asked for: a million of
 * them are a few large arrays. It grows at its end, block by block, wherever the blocks come from.
 */
export class Store {
  private readonly blocks: Stored[] = [];
  private column = new Uint8Array(1024);
  private count = 0;
  private open: { readonly block: Stored; readonly text: BlockText } | null = null;
  private last: { readonly step: number; readonly event: Event } | null = null;

  get length(): number {
    return this.count;
  }

  /** The numbers of the events' names, that of step n at n - 1: a long run is gone through by these first. */
  get names(): Uint8Array {
    return this.column.subarray(0, this.count);
  }

  append(block: Block): void {
    this.blocks.push({ ...block, before: this.count });
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

  /** The same without the depths of its pixels, which may be nearly all of a long line. */
  eventWithoutDepths(step: number): Event | null {
    if (step < 1 || step > this.count) return null;
    const line = this.line(step);
    const at = line.indexOf(depths);
    if (at < 0) return this.event(step);
    return JSON.parse(line.slice(0, at) + line.slice(line.indexOf(']', at) + 1)) as Event;
  }

  /** The text of a step's line. */
  line(step: number): string {
    const { block, text } = this.blockOf(step);
    return text.line(step - 1 - block.before);
  }

  /** Keeps the text of the block that was asked for last: neighbours are asked for one after the other. */
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

function isIn({ before, names }: Stored, step: number): boolean {
  return step > before && step <= before + names.length;
}
