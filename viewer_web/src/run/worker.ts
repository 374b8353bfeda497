import { Library } from './library.js';
import type { Outcome } from './library.js';
import { readMade } from './made.js';
import type { Made } from './made.js';

/** The results that the library makes for the page. */
export interface Makes {
  readonly trace: Made;
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
  const outcome = library.run(request);
  const { made } = outcome;
  // The arrays, which all blocks share, are transferred and not copied.
  const given = made === null ? [] : [made.bytes.buffer, made.starts.buffer, made.names.buffer];
  scope.postMessage({ turn, ...outcome, made: made && readMade(made) }, given);
};
