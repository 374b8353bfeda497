import { isFamily } from '../trace/events.js';
import type { Detail, Method } from '../trace/events.js';
import { editions, isMistake } from '../trace/editions.js';
import type { Edition, Mistake } from '../trace/editions.js';

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

const eitherMethod = ['warnock', 'zbuffer'] as const;

/** The methods in which a usual mistake can be made. */
const methodsOf: Readonly<Record<Mistake, readonly Method[]>> = {
  'one-list': ['warnock'],
  'depths-not-cleared': ['zbuffer'],
  'clip-order-reversed': ['warnock'],
  'y-flipped': eitherMethod,
  'depth-sign-reversed': eitherMethod,
  'boundary-outside': eitherMethod,
  'integer-division': ['warnock'],
  'surround-kept': ['warnock'],
  'vertex-counted-twice': ['warnock-full'],
  'octants-not-split': ['warnock-angles'],
  'line-for-edge': ['warnock-full'],
};

/** Whether the method has a text of that edition. */
function hasEdition(method: Method, edition: Edition): boolean {
  if (isMistake(edition)) return methodsOf[edition].includes(method);
  return edition === 'corrected' || !(isFamily(method) || method === 'weiler-atherton');
}

/** The editions of a method's text. */
export const editionsOf = (method: Method): readonly Edition[] =>
  editions.filter((edition) => hasEdition(method, edition));

/** Of the editions' names those that a method has. */
export function offeredNames(
  method: Method,
  names: Readonly<Record<Edition, string>>,
): Record<string, string> {
  return Object.fromEntries(editionsOf(method).map((edition) => [edition, names[edition]]));
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
  if (!hasEdition(method, edition)) return false;
  if (isMistake(edition)) return kernel === 'double' || kernel === 'exact';
  if (kernel.startsWith('depth:')) return method === 'zbuffer';
  if (kernel === 'filtered') return edition === 'corrected';
  if (!kernel.startsWith('grid:')) return true;
  return edition === 'corrected' && method !== 'floating-horizon' && method !== 'weiler-atherton';
}

/** The nearest to some options that can be run: the kernel gives way, and an edition that the method does not have. */
export function runnable(options: Options): Options {
  if (runs(options)) return options;
  return hasEdition(options.method, options.edition)
    ? { ...options, kernel: usual.kernel }
    : runnable({ ...options, edition: usual.edition });
}
