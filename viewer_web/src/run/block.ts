import type { Block } from '../trace/store.js';
import type { MadeTrace } from './library.js';

/** Bytes of a block. All its text is decoded when one of its lines is requested. */
const size = 2 ** 16;

export interface Written {
  readonly header: string;
  readonly blocks: readonly Block[];
  readonly end: string;
}

/** A trace as its first line, blocks of lines, and its last line; all blocks share its arrays. */
export function writtenOf({ bytes, starts, names }: MadeTrace): Written {
  const text = new TextDecoder();
  const blocks: Block[] = [];
  for (let first = 0; first < names.length;) {
    const begin = starts[first] ?? 0;
    let end = first + 1;
    while (end < names.length && (starts[end] ?? 0) - begin < size) end++;
    blocks.push({
      bytes,
      starts: starts.subarray(first, end + 1),
      names: names.subarray(first, end),
    });
    first = end;
  }
  return {
    header: text.decode(bytes.subarray(0, starts[0])),
    blocks,
    end: text.decode(bytes.subarray(starts.at(-1))),
  };
}
