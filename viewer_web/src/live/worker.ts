import type { Header } from '../trace/header.js';
import { parseHeader } from '../trace/header.js';
import { parseJson, parseLine } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import type { Block } from '../trace/store.js';
import { linesOf } from './block.js';
import { Library } from './library.js';

/** What the page asks for: at first the library, then runs. */
export type Order =
  { readonly library: WebAssembly.Module } | { readonly turn: number; readonly request: string };

/** A run, whole; or why there is none. */
export interface Answer {
  readonly turn: number;
  readonly messages: string;
  readonly made: {
    readonly header: Header;
    readonly blocks: readonly Block[];
    readonly end: End;
  } | null;
}

/** What of the global scope a worker has and a page has not. */
interface Scope {
  onmessage: ((message: MessageEvent<Order>) => void) | null;
  postMessage(answer: Answer, transfer: readonly Transferable[]): void;
}
const scope = globalThis as unknown as Scope;

let library: Library | null = null;

function answerTo(turn: number, request: string): Answer {
  if (library === null) throw new Error('no library yet');
  const { trace, messages } = library.run(request);
  if (trace === null) return { turn, messages, made: null };
  const { header: first, blocks, end: last } = linesOf(trace);
  const header = parseHeader(parseJson(first));
  const line = parseLine(last, header);
  if (!('end' in line)) throw new Error('the trace has no end');
  return { turn, messages, made: { header, blocks, end: line.end } };
}

/** The bytes, which all blocks share, are given away and not copied. */
function given({ made }: Answer): readonly Transferable[] {
  const [first] = made?.blocks ?? [];
  return first === undefined ? [] : [first.bytes.buffer];
}

scope.onmessage = ({ data }) => {
  if ('library' in data) {
    library = new Library(data.library);
    return;
  }
  const answer = answerTo(data.turn, data.request);
  scope.postMessage(answer, given(answer));
};
