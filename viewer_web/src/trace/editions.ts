import type { Check } from './check.js';
import choices from './choices.json' with { type: 'json' };
import { Refusal, describe } from './refusal.js';

/** The output of `vidno methods --json`: the editions of the procedures, and the kernels under which they run. */

/** A text in each language of the program. */
type Bilingual = Readonly<(typeof choices.methods)['warnock']['title']>;

/** The editions with a name of their own. */
export type NamedEdition = keyof typeof choices.editions;
export const editions = Object.keys(choices.editions) as readonly NamedEdition[];

/** An edition with single defects of the printed text lists their ids: "printed:x-w2+x-w4". */
type SingleDefects = `printed:${string}`;
export type Edition = NamedEdition | SingleDefects;
const singles = 'printed:';

/** A deviation from the corrected procedures: a defect of the printed text, or a usual mistake. */
export interface Deviation {
  readonly edition: Edition;
  /** Its id in the printed text, if it is a defect of that text. */
  readonly defect: string | null;
  readonly title: Bilingual;
  /** Its effect. */
  readonly says: Bilingual;
  /** The lines of the listings that it changes. */
  readonly lines: readonly string[];
  /** For a usual mistake, the text of these lines in order; empty for a defect, whose text the listings have. */
  readonly reads: readonly Bilingual[];
  readonly methods: readonly string[];
}
export const deviations: readonly Deviation[] = Object.entries(choices.deviations).map(
  ([edition, { title, says, lines, methods, ...more }]) => ({
    edition: edition as Edition,
    defect: 'defect' in more ? more.defect : null,
    title,
    says,
    lines,
    reads: 'reads' in more ? more.reads : [],
    methods,
  }),
);

const isNamed = (edition: string): edition is NamedEdition =>
  Object.hasOwn(choices.editions, edition);

/** The ids of the defects in the name of an edition. */
function singlesIn(edition: string): readonly string[] {
  return edition.startsWith(singles) ? edition.slice(singles.length).split('+') : [];
}

const withDefect = (id: string): Deviation | undefined =>
  deviations.find(({ defect }) => defect === id);

export function isEdition(name: string): name is Edition {
  const ids = singlesIn(name);
  return isNamed(name) || (ids.length > 0 && ids.every((id) => withDefect(id) !== undefined));
}

/** The check of an edition's name in files. */
export const edition: Check<Edition> = (value, path) => {
  if (typeof value === 'string' && isEdition(value)) return value;
  throw new Refusal(path, 'oneOf', editions.join(', '), describe(value));
};

/** The usual mistakes. Each changes some of the corrected procedures. */
export type Mistake = Exclude<NamedEdition, 'corrected' | 'printed'>;
export const isMistake = (name: Edition): name is Mistake =>
  isNamed(name) && choices.editions[name].isMistake;

/** The deviation of an edition, if it has exactly one. */
export const deviationOf = (name: Edition): Deviation | null =>
  deviations.find((each) => each.edition === name) ?? null;

/** Whether an edition has the defect of the printed text with this id. */
export function hasDefect(name: Edition, id: string): boolean {
  const named = deviationOf(name)?.defect ?? null;
  return name === 'printed' || named === id || singlesIn(name).includes(id);
}

export type MethodName = keyof typeof choices.methods;
export const methodNames = Object.keys(choices.methods) as readonly MethodName[];

/** A variant of Warnock's algorithm: its text is the corrected one. */
export const isFamily = (method: MethodName): boolean => method.startsWith('warnock-');

/** The program's names of editions and methods, and descriptions of them, by language. */
export const editionTitle = (name: NamedEdition): Bilingual => choices.editions[name].title;
export const methodTitle = (method: MethodName): Bilingual => choices.methods[method].title;
export const methodSays = (method: MethodName): Bilingual => choices.methods[method].says;

/** The method that paints the right picture of this one, under a kernel that is always right. */
export const referenceOf = (method: MethodName): MethodName =>
  choices.methods[method].reference as MethodName;

/** The kernels under which each edition of a method runs. */
export const kernelsOf = (
  method: MethodName,
): Readonly<Partial<Record<NamedEdition, readonly string[]>>> => choices.methods[method].editions;

/**
 * Whether a method runs in an edition under a kernel. Single defects need a method with those defects, and run under the
 * kernels of the printed edition.
 */
export function runsUnder(method: MethodName, name: Edition, kernel: string): boolean {
  const ids = singlesIn(name);
  const isOfMethod = ids.every((id) => withDefect(id)?.methods.includes(method) === true);
  const like = isNamed(name) ? name : 'printed';
  return isOfMethod && kernelsOf(method)[like]?.includes(kindOfKernel(kernel)) === true;
}

/** Colours that are distinguishable with colour blindness and in grey. A scene without colours takes them in turn. */
export const palette: readonly string[] = choices.palette;

interface Kernel {
  readonly says: Bilingual;
  readonly alwaysRight: boolean;
  readonly snaps: boolean;
  readonly parameter?: {
    readonly least: number;
    readonly most: number;
    readonly offered: readonly number[];
  };
}
const kernels: Readonly<Record<string, Kernel>> = choices.kernels;

/** The kernels without a number after a colon. */
export type PlainKernel = {
  [K in keyof typeof choices.kernels]: (typeof choices.kernels)[K] extends { parameter: unknown }
    ? never
    : K;
}[keyof typeof choices.kernels];
export const plainKernels = Object.keys(kernels).filter(
  (name): name is PlainKernel => kernels[name]?.parameter === undefined,
);

/** The kernels that the page offers; for those with a number after the colon, at some values. */
export const offeredKernels: readonly string[] = Object.entries(kernels).flatMap(
  ([name, { parameter }]) => parameter?.offered.map((number) => `${name}:${number}`) ?? [name],
);

/** The kernel without the number after its colon. */
const kindOfKernel = (kernel: string): string => kernel.split(':')[0] ?? kernel;

/** The arithmetic of a kernel, in words. */
export function kernelSays(kernel: string): Bilingual {
  const { says } = kernels[kindOfKernel(kernel)] ?? { says: { en: '', ru: '' } };
  return says;
}

/** Whether a kernel always decides as exact arithmetic does, even unchecked. */
export const isAlwaysRight = (kernel: string): boolean =>
  kernels[kindOfKernel(kernel)]?.alwaysRight === true;

/** Whether it does so for the scene as given; some kernels are right only for the scene that they snap. */
export const isRightAsGiven = (kernel: string): boolean =>
  isAlwaysRight(kernel) && kernels[kindOfKernel(kernel)]?.snaps === false;
