import { isFamily } from '../trace/events.js';
import type { Detail, Method } from '../trace/events.js';
import { isMistake } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';

/** How a scene is run. */
export interface Options {
  readonly method: Method;
  readonly edition: Edition;
  readonly kernel: string;
  readonly detail: Detail;
  /** Whether every decision is held against exact arithmetic. */
  readonly check: boolean;
}

export const usual: Options = {
  method: 'warnock',
  edition: 'corrected',
  kernel: 'double',
  detail: 'signs',
  check: false,
};

/** The kernels that the page offers, those with a number behind the colon at one or two of its values. */
export const kernels = [
  'float',
  'double',
  'bits:8',
  'bits:12',
  'depth:8',
  'depth:16',
  'filtered',
  'grid:4',
  'grid:8',
  'exact',
] as const;

/** Whether the method has a text as printed. */
export const isPrinted = (method: Method): boolean =>
  !isFamily(method) && method !== 'weiler-atherton';

/** Of the editions' names those that the page offers: its library has no usual mistakes, a variant no printed text. */
export function offeredNames(
  method: Method,
  { corrected, printed }: Readonly<Record<Edition, string>>,
): Record<string, string> {
  return isPrinted(method) ? { corrected, printed } : { corrected };
}

/** Of the methods' names those that draw a scene of polygons, or one of curves. */
export function methodNames(
  names: Readonly<Record<Method, string>>,
  { method }: Pick<Options, 'method'>,
): Record<string, string> {
  const { 'floating-horizon': curves, ...polygons } = names;
  return method === 'floating-horizon' ? { [method]: curves } : polygons;
}

/** Whether a method and an edition run under a kernel. */
export function runs({ method, edition, kernel }: Omit<Options, 'detail' | 'check'>): boolean {
  if (kernel.startsWith('depth:')) return method === 'zbuffer';
  if (kernel.startsWith('grid:') && method === 'floating-horizon') return false;
  if (isMistake(edition)) return false;
  if (method === 'weiler-atherton' && kernel.startsWith('grid:')) return false;
  if (!isPrinted(method)) return edition === 'corrected';
  return edition === 'corrected' || !/^(filtered|grid:.*)$/.test(kernel);
}

/** The nearest to some options that can be run: the corrected text, the usual kernel. */
export function runnable(options: Options): Options {
  if (runs(options)) return options;
  const isTold = !isMistake(options.edition) && isPrinted(options.method);
  return isTold
    ? { ...options, kernel: usual.kernel }
    : { ...options, edition: usual.edition, kernel: kernelOf(options) };
}

/** A kernel under which the corrected text of the method runs. */
function kernelOf({ method, kernel }: Options): string {
  return runs({ method, edition: usual.edition, kernel }) ? kernel : usual.kernel;
}
