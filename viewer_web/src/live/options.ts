import type { Detail, Method } from '../trace/events.js';
import { has, isMistake } from '../trace/editions.js';
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

/** Whether a method has an edition and both run under a kernel. */
export function runs({ method, edition, kernel }: Omit<Options, 'detail' | 'check'>): boolean {
  if (isMistake(edition)) return has(method, edition) && /^(double|exact)$/.test(kernel);
  if (kernel.startsWith('depth:')) return method === 'zbuffer';
  return edition === 'corrected' || !/^(filtered|grid:.*)$/.test(kernel);
}

/** The nearest to some options that can be run: a mistake that the method has not gives way, then the kernel. */
export function runnable(options: Options): Options {
  const edition = has(options.method, options.edition) ? options.edition : usual.edition;
  const nearest = { ...options, edition };
  return runs(nearest) ? nearest : { ...nearest, kernel: usual.kernel };
}
