import choices from './choices.json' with { type: 'json' };

/** What `vidno methods --json` says: the editions of the procedures, and under which kernels they run. */

export type Edition = keyof typeof choices.editions;
export const editions = Object.keys(choices.editions) as readonly Edition[];

/** The usual mistakes, each in procedures that are else the corrected ones. */
export type Mistake = Exclude<Edition, 'corrected' | 'printed'>;
export const isMistake = (edition: Edition): edition is Mistake =>
  choices.editions[edition].isMistake;

type MethodName = keyof typeof choices.methods;

/** By editions of a method's text the kernels under which it runs. */
export const kernelsOf = (
  method: MethodName,
): Readonly<Partial<Record<Edition, readonly string[]>>> => choices.methods[method].editions;

interface Kernel {
  readonly alwaysRight: boolean;
  readonly parameter?: { readonly least: number; readonly most: number };
}
const kernels: Readonly<Record<string, Kernel>> = choices.kernels;

/** The kernel without the number behind its colon. */
export const kindOfKernel = (kernel: string): string => kernel.split(':')[0] ?? kernel;

/** Whether a kernel decides as exact arithmetic does, checked or not. */
export const isAlwaysRight = (kernel: string): boolean =>
  kernels[kindOfKernel(kernel)]?.alwaysRight === true;

/** The names of the kernels: "double", "bits:12". */
export const kernelName = new RegExp(
  `^(?:${Object.entries(kernels)
    .map(([name, { parameter }]) => {
      if (parameter === undefined) return name;
      const { least, most } = parameter;
      const numbers = Array.from({ length: most - least + 1 }, (_, i) => String(least + i));
      return `${name}:(?:${numbers.join('|')})`;
    })
    .join('|')})$`,
  'u',
);
