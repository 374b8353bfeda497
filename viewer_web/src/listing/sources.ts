import { hasDefect, isMistake } from '../trace/editions.js';
import type { Edition, Mistake } from '../trace/editions.js';
import { isFamily } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { namesOf } from './listings.js';

const root = '../../../lib/vidno/';
const texts = import.meta.glob<string>(
  [
    '../../../lib/vidno/*/*.h',
    // No listing leads to these.
    '!../../../lib/vidno/{admission,kernels}/*',
    '!../../../lib/vidno/*/*_{kernel,run}.h',
    '!../../../lib/vidno/family/{calls,closed_bodies,windows}.h',
    '../../../lib/vidno/{corrected,printed}.h',
  ],
  { query: '?raw', import: 'default', eager: true },
);

/** A line of C++ without its indentation. */
export interface SourceLine {
  readonly indent: number;
  readonly text: string;
}

/** The file of the library that contains a procedure, or the rules in which the editions differ. */
export interface Source {
  readonly path: string;
  readonly lines: readonly SourceLine[];
}

/** The files of procedures that are not in a single file with their name. */
const filesOfOthers: Readonly<Record<string, readonly string[]>> = {
  SimplestWarnock: ['simplest.h'],
  ThreeListsWarnock: ['three_lists.h', 'polygon_lists.h'],
  RegionClip: ['region_clip.h', 'overlay.h', 'loops.h', 'region.h'],
  Relation: ['relation_test.h', 'box_test.h'],
};

const filesOf = (name: string): readonly string[] => filesOfOthers[name] ?? [fileOf(name)];

const fileOf = (name: string): string =>
  `${name.replace(/(?<=.)(?=[A-Z][a-z])/g, '_').toLowerCase()}.h`;

const linesOf = (text: string): readonly SourceLine[] =>
  text
    .trimEnd()
    .split('\n')
    .map((line) => ({ indent: line.length - line.trimStart().length, text: line.trim() }));

const mistakePath = (mistake: Mistake): string => `mistakes/${mistake.replaceAll('-', '_')}.h`;

const paths = Object.keys(texts).map((path) => path.slice(root.length));
const isOfEdition = (path: string): boolean => /^(printed|mistakes)\//.test(path);

/** The path of a file of a procedure; undefined if the procedure has no file of its own. */
function pathOf(file: string, asPrinted: boolean): string | undefined {
  const usual = paths.find((path) => !isOfEdition(path) && path.endsWith(`/${file}`));
  const printed = `printed/${file}`;
  return asPrinted && paths.includes(printed) ? printed : usual;
}

/** The files with the rules of an edition: the usual ones, and those in which it differs. */
function rulesOf(method: Method, edition: Edition): readonly string[] {
  const usual = [...(isFamily(method) ? ['family/family.h'] : []), 'corrected.h'];
  if (edition === 'corrected') return usual;
  if (edition === 'printed') return ['printed.h'];
  if (isMistake(edition)) return [...usual, mistakePath(edition)];
  return [...usual, method === 'zbuffer' ? 'printed/z_buffer_defects.h' : 'printed.h'];
}

/** The procedures whose whole printed text is a single defect. */
const wholeDefects: Readonly<Record<string, string>> = {
  'surround_test.h': 'x-w4',
  'initialize_polygon.h': 'x-w6',
};

/** Whether an edition has the printed version of a procedure. */
const isAsPrinted = (file: string, edition: Edition): boolean =>
  edition === 'printed' || hasDefect(edition, wholeDefects[file] ?? '');

/** Whether a mistake replaces a procedure and does not call the usual one. */
function replaces(edition: Edition, procedure: string): boolean {
  if (!isMistake(edition)) return false;
  const text = texts[root + mistakePath(edition)] ?? '';
  return text.includes(` ${procedure}(auto& run`) && !text.includes(`Corrected::${procedure}(`);
}

/** The C++ code of a run's procedures, in the order of their listings, and the rules of its edition. */
export function sourcesOf({
  method,
  edition,
}: Pick<Header, 'method' | 'edition'>): readonly Source[] {
  const ofProcedures = namesOf(method)
    .flatMap(filesOf)
    .filter((file) => !replaces(edition, file.replace('.h', '')))
    .map((file) => pathOf(file, isAsPrinted(file, edition)));
  return [...ofProcedures, ...rulesOf(method, edition)]
    .filter((path) => path !== undefined)
    .map((path) => ({ path, lines: linesOf(texts[root + path] ?? '') }));
}

/** The lines of a source that record the event: those with its label, preferably those that name the event. */
export function linesThatReport({ e, at }: Event, { lines }: Source): readonly number[] {
  const calls = new RegExp(`\\b(\\w+)\\((?:[^()]*\\W)?${at}\\b`, 'g');
  const found = lines.flatMap(({ text }, number) =>
    [...text.matchAll(calls)].map(([, called = '']) => ({ number, named: called.includes(e) })),
  );
  const named = found.filter((each) => each.named);
  return (named.length > 0 ? named : found).map(({ number }) => number);
}
