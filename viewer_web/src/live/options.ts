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

/** Of the editions' names those that the page offers: its library has no usual mistakes. */
export function offeredNames(names: Readonly<Record<Edition, string>>): Record<string, string> {
  return { corrected: names.corrected, printed: names.printed };
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
  return edition === 'corrected' || !/^(filtered|grid:.*)$/.test(kernel);
}

/** The nearest to some options that can be run: a mistake gives way to the corrected text, then the kernel. */
export function runnable(options: Options): Options {
  if (isMistake(options.edition)) return runnable({ ...options, edition: usual.edition });
  return runs(options) ? options : { ...options, kernel: usual.kernel };
}
