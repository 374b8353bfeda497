import { parseHeader } from '../trace/header.js';
import type { Header } from '../trace/header.js';
import { parseJson, parseLine } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import type { Block } from '../trace/store.js';
import { writtenOf } from './block.js';
import type { MadeTrace } from './library.js';

/** A trace made by the library. */
export interface Made {
  readonly header: Header;
  readonly blocks: readonly Block[];
  readonly end: End;
}

export function readMade(trace: MadeTrace): Made {
  const { header: first, blocks, end: last } = writtenOf(trace);
  const header = parseHeader(parseJson(first));
  const line = parseLine(last, header);
  if (!('end' in line)) throw new Error('the trace has no end');
  return { header, blocks, end: line.end };
}
