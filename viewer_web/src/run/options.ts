import { editions, kernelsOf, runsUnder } from '../trace/editions.js';
export { offeredKernels as kernels } from '../trace/editions.js';
import { editionName } from '../language/family.js';
import type { Edition, NamedEdition } from '../trace/editions.js';
import type { Detail, Method } from '../trace/events.js';

/** The settings for running a scene. */
export interface Options {
  readonly method: Method;
  readonly edition: Edition;
  readonly kernel: string;
  readonly detail: Detail;
  /** Whether every decision is compared with exact arithmetic. */
  readonly check: boolean;
}

export const usual: Options = {
  method: 'warnock',
  edition: 'corrected',
  kernel: 'double',
  detail: 'signs',
  check: false,
};

/** The settings for a first look at a scene: as few steps as possible. */
export const brief: Options = { ...usual, detail: 'windows' };

/** The named editions of a method. */
export const editionsOf = (method: Method): readonly NamedEdition[] =>
  editions.filter((edition) => kernelsOf(method)[edition] !== undefined);

/** The names of the editions that a method has, including the current one. */
export function offeredNames(
  { method, edition: chosen }: Pick<Options, 'method' | 'edition'>,
  names: Readonly<Record<NamedEdition, string>>,
): Record<string, string> {
  const offered = new Set<Edition>([...editionsOf(method), chosen]);
  return Object.fromEntries([...offered].map((edition) => [edition, editionName(names, edition)]));
}

/** The names of the methods that draw a scene of polygons, or of those that draw curves. */
export function methodNames(
  names: Readonly<Record<Method, string>>,
  { method }: Pick<Options, 'method'>,
): Record<string, string> {
  const { 'floating-horizon': curves, ...polygons } = names;
  return method === 'floating-horizon' ? { [method]: curves } : polygons;
}

/** Whether a method and an edition run under a kernel. */
export function runs({ method, edition, kernel }: Omit<Options, 'detail' | 'check'>): boolean {
  return runsUnder(method, edition, kernel);
}

/** The nearest options that can be run. They get another kernel, and another edition if the method does not have it. */
export function runnable(options: Options): Options {
  if (runs(options)) return options;
  const plainly = { ...options, kernel: usual.kernel };
  return runs(plainly) ? plainly : runnable({ ...options, edition: usual.edition });
}
