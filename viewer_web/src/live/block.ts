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

export interface Written {
  readonly header: string;
  readonly block: Block;
  readonly end: string;
}

/** Finds the lines in a whole trace as the library writes it, which needs no checks. */
export function linesOf(bytes: Uint8Array<ArrayBuffer>): Written {
  const starts: number[] = [];
  for (let at = 0; at < bytes.length; at = bytes.indexOf(newline, at) + 1) starts.push(at);
  const events = starts.length - 2;
  const names = new Uint8Array(events);
  for (let i = 0; i < events; i++) {
    names[i] = numbers[mixed(bytes, (starts[i + 1] ?? 0) + opening)] ?? 0;
  }
  const text = new TextDecoder();
  return {
    header: text.decode(bytes.subarray(0, starts[1])),
    block: { bytes, starts: Uint32Array.from(starts.slice(1)), names },
    end: text.decode(bytes.subarray(starts.at(-1))),
  };
}
