import { leveled } from './leveled.js';
import { Library } from './library.js';
import type { Outcome } from './library.js';
import type { Options } from './options.js';

/** The results that the library makes for the page. */
export interface Makes {
  /** The bytes of a trace. */
  readonly trace: Uint8Array<ArrayBuffer>;
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

/** The findings of a run, with their steps at its level of detail: the library counts them at level `signs`. */
function findingsAtLevel(from: Library, request: string): Outcome<string> {
  const outcome = from.findings(request);
  const [options = '', scene = ''] = request.split('\n');
  const wanted = JSON.parse(options) as Options & { readonly most_events: number };
  if (outcome.made === null || wanted.detail === 'signs') return outcome;
  const [header = '', ...lines] = outcome.made.trimEnd().split('\n');
  const findings = lines.map((line) => JSON.parse(line) as { readonly step: number });
  const signs = JSON.stringify({ ...wanted, detail: 'signs', check: false });
  const steps = findings.map(({ step }) => step);
  const { made } = from.run(`${signs}\n${scene}`, (bytes) => leveled(bytes, wanted.detail, steps));
  if (made === null) return { ...outcome, made: null };
  const placed = made.map((at, i) => JSON.stringify({ ...findings[i], ...at }));
  return { ...outcome, made: [header, ...placed, ''].join('\n') };
}

let library: Library | null = null;

scope.onmessage = ({ data }) => {
  if ('library' in data) {
    library = new Library(data.library);
    return;
  }
  if (library === null) throw new Error('no library yet');
  const { turn, what, request } = data;
  if (what === 'findings') {
    scope.postMessage({ turn, ...findingsAtLevel(library, request) }, []);
    return;
  }
  if (what !== 'trace') {
    scope.postMessage({ turn, ...library[what](request) }, []);
    return;
  }
  const outcome = library.run(request, (bytes) => bytes.slice());
  scope.postMessage({ turn, ...outcome }, outcome.made === null ? [] : [outcome.made.buffer]);
};
