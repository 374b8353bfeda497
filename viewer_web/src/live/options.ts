import type { Detail, Method } from '../trace/events.js';
import type { Edition } from '../trace/header.js';

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

/** Whether a method and an edition run under a kernel. */
export function runs({ method, edition, kernel }: Omit<Options, 'detail' | 'check'>): boolean {
  if (kernel.startsWith('depth:')) return method === 'zbuffer';
  return edition === 'corrected' || !/^(filtered|grid:.*)$/.test(kernel);
}

/** The nearest to some options that can be run: the kernel is what gives way. */
export function runnable(options: Options): Options {
  return runs(options) ? options : { ...options, kernel: usual.kernel };
}
