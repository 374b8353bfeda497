import { parseHeader } from '../trace/header.js';
import type { Header } from '../trace/header.js';
import { parseJson, parseLine } from '../trace/parse.js';
import type { End } from '../trace/parse.js';
import type { Block } from '../trace/store.js';
import { writtenOf } from './block.js';
import { Library } from './library.js';
import type { MadeTrace, Outcome } from './library.js';

/** The results that the library makes for the page. */
export interface Makes {
  readonly trace: {
    readonly header: Header;
    readonly blocks: readonly Block[];
    readonly end: End;
  };
  readonly map: string;
  readonly findings: string;
  readonly margin: string;
  readonly failure: string;
}
export type What = keyof Makes;

/** The page's requests: first the library, then results. */
export type Order =
  | { readonly library: WebAssembly.Module }
  | { readonly turn: number; readonly what: What; readonly request: string };

/** A complete result, or the reason why there is none. */
export type Answer<W extends What> = Outcome<Makes[W]> & { readonly turn: number };

/** The part of a worker's global scope that a page's scope does not have. */
interface Scope {
  onmessage: ((message: MessageEvent<Order>) => void) | null;
  postMessage(answer: Answer<What>, transfer: readonly Transferable[]): void;
}
const scope = globalThis as unknown as Scope;

let library: Library | null = null;

function read(trace: MadeTrace): Makes['trace'] {
  const { header: first, blocks, end: last } = writtenOf(trace);
  const header = parseHeader(parseJson(first));
  const line = parseLine(last, header);
  if (!('end' in line)) throw new Error('the trace has no end');
  return { header, blocks, end: line.end };
}

scope.onmessage = ({ data }) => {
  if ('library' in data) {
    library = new Library(data.library);
    return;
  }
  if (library === null) throw new Error('no library yet');
  const { turn, what, request } = data;
  if (what !== 'trace') {
    scope.postMessage({ turn, ...library[what](request) }, []);
    return;
  }
  const { made, messages } = library.run(request);
  // The bytes, which all blocks share, are transferred and not copied.
  const given = made === null ? [] : [made.bytes.buffer];
  scope.postMessage({ turn, messages, made: made && read(made) }, given);
};
