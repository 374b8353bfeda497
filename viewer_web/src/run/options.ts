import { editions, kernelsOf, kindOfKernel } from '../trace/editions.js';
export { offeredKernels as kernels } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import type { Detail, Method } from '../trace/events.js';

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

/** The editions of a method's text. */
export const editionsOf = (method: Method): readonly Edition[] =>
  editions.filter((edition) => kernelsOf(method)[edition] !== undefined);

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
  return kernelsOf(method)[edition]?.includes(kindOfKernel(kernel)) ?? false;
}

/** The nearest to some options that can be run: the kernel gives way, and an edition that the method does not have. */
export function runnable(options: Options): Options {
  if (runs(options)) return options;
  return editionsOf(options.method).includes(options.edition)
    ? { ...options, kernel: usual.kernel }
    : runnable({ ...options, edition: usual.edition });
}
