import { Library } from './library.js';
import type { Outcome, Request } from './library.js';

/** The results that the library makes for the page. */
export interface Makes {
  /** The bytes of a trace. */
  readonly trace: Uint8Array<ArrayBuffer>;
  readonly map: string;
  readonly findings: string;
  readonly margin: string;
  readonly scene: string;
  readonly failure: string;
}
export type What = keyof Makes;

/** The page's requests: first the library, then results. */
export type Order =
  | { readonly library: WebAssembly.Module }
  | { readonly turn: number; readonly what: What; readonly request: Request };

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
  const outcome = library.run(request, (bytes) => bytes.slice());
  scope.postMessage({ turn, ...outcome }, outcome.made === null ? [] : [outcome.made.buffer]);
};
