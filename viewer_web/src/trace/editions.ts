import choices from './choices.json' with { type: 'json' };

/** What `vidno methods --json` says: the editions of the procedures, and under which kernels they run. */

interface Bilingual {
  readonly en: string;
  readonly ru: string;
}

export type Edition = keyof typeof choices.editions;
export const editions = Object.keys(choices.editions) as readonly Edition[];

/** The usual mistakes, each in procedures that are else the corrected ones. */
export type Mistake = Exclude<Edition, 'corrected' | 'printed'>;
export const isMistake = (edition: Edition): edition is Mistake =>
  choices.editions[edition].isMistake;

export type MethodName = keyof typeof choices.methods;
export const methodNames = Object.keys(choices.methods) as readonly MethodName[];

/** A variant of Warnock's algorithm: its text is the corrected one. */
export const isFamily = (method: MethodName): boolean => method.startsWith('warnock-');

/** What the program calls editions and methods, and says of these, by languages. */
export const editionTitle = (edition: Edition): Bilingual => choices.editions[edition].title;
export const methodTitle = (method: MethodName): Bilingual => choices.methods[method].title;
export const methodSays = (method: MethodName): Bilingual => choices.methods[method].says;

/** By editions of a method's text the kernels under which it runs. */
export const kernelsOf = (
  method: MethodName,
): Readonly<Partial<Record<Edition, readonly string[]>>> => choices.methods[method].editions;

/** Colours that stay apart for colour-blind eyes and in grey; a scene that names none takes them in turn. */
export const palette: readonly string[] = choices.palette;

interface Kernel {
  readonly alwaysRight: boolean;
  readonly snaps: boolean;
  readonly parameter?: {
    readonly least: number;
    readonly most: number;
    readonly offered: readonly number[];
  };
}
const kernels: Readonly<Record<string, Kernel>> = choices.kernels;

/** Those without a number behind a colon. */
export type PlainKernel = {
  [K in keyof typeof choices.kernels]: (typeof choices.kernels)[K] extends { parameter: unknown }
    ? never
    : K;
}[keyof typeof choices.kernels];
export const plainKernels = Object.keys(kernels).filter(
  (name): name is PlainKernel => kernels[name]?.parameter === undefined,
);

/** The kernels that the page offers, those with a number behind the colon at some of its values. */
export const offeredKernels: readonly string[] = Object.entries(kernels).flatMap(
  ([name, { parameter }]) => parameter?.offered.map((number) => `${name}:${number}`) ?? [name],
);

/** The kernel without the number behind its colon. */
export const kindOfKernel = (kernel: string): string => kernel.split(':')[0] ?? kernel;

/** Whether a kernel decides as exact arithmetic does, checked or not. */
export const isAlwaysRight = (kernel: string): boolean =>
  kernels[kindOfKernel(kernel)]?.alwaysRight === true;

/** The same of the scene as it is given; others are so of the scene that they snap. */
export const isRightAsGiven = (kernel: string): boolean =>
  isAlwaysRight(kernel) && kernels[kindOfKernel(kernel)]?.snaps === false;

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
