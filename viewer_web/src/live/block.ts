import { eventNames } from '../trace/events.js';
import type { Block } from '../trace/store.js';

const newline = 10;
const quote = 34;
/** Before the name of an event: `{"e":"`. */
const opening = 6;

/** A number for the bytes of a name: those of the events differ in it. */
function mixed(bytes: Uint8Array, from: number): number {
  let mix = 0;
  for (let at = from; bytes[at] !== quote; at++) mix = (mix * 31 + (bytes[at] ?? quote)) & 0xffff;
  return mix;
}

function tableOfNames(): Uint8Array {
  const table = new Uint8Array(0x10000).fill(255);
  const encoder = new TextEncoder();
  eventNames.forEach((name, number) => {
    const at = mixed(encoder.encode(`${name}"`), 0);
    if (table[at] !== 255) throw new Error(`The name ${name} needs another mixture.`);
    table[at] = number;
  });
  return table;
}

const numbers = tableOfNames();

/** Bytes of a block: its text is made as a whole when one of its lines is asked for. */
const size = 2 ** 16;

export interface Written {
  readonly header: string;
  readonly blocks: readonly Block[];
  readonly end: string;
}

/** Finds the lines in a whole trace as the library writes it, which needs no checks. */
export function linesOf(bytes: Uint8Array<ArrayBuffer>): Written {
  const starts: number[] = [];
  for (let at = 0; at < bytes.length; at = bytes.indexOf(newline, at) + 1) starts.push(at);
  const text = new TextDecoder();
  return {
    header: text.decode(bytes.subarray(0, starts[1])),
    blocks: blocksOf(bytes, starts.slice(1)),
    end: text.decode(bytes.subarray(starts.at(-1))),
  };
}

/** The lines that begin at all of the places but the last, where the last one ends. */
function blocksOf(bytes: Uint8Array<ArrayBuffer>, places: readonly number[]): readonly Block[] {
  const blocks: Block[] = [];
  for (let first = 0; first < places.length - 1;) {
    const begin = places[first] ?? 0;
    let end = first + 1;
    while (end < places.length - 1 && (places[end] ?? 0) - begin < size) end++;
    const starts = places.slice(first, end + 1);
    blocks.push({
      bytes: bytes.subarray(begin, starts.at(-1)),
      starts: Uint32Array.from(starts, (place) => place - begin),
      names: Uint8Array.from(starts.slice(0, -1), (place) => nameAt(bytes, place)),
    });
    first = end;
  }
  return blocks;
}

const nameAt = (bytes: Uint8Array, line: number): number =>
  numbers[mixed(bytes, line + opening)] ?? 0;
