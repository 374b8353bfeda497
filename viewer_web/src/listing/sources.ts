import { hasDefect, isMistake } from '../trace/editions.js';
import type { Edition, Mistake } from '../trace/editions.js';
import { isFamily } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { namesOf } from './listings.js';

const root = '../../../lib/vidno/';
const texts = import.meta.glob<string>(
  [
    '../../../lib/vidno/{warnock,z_buffer,family,floating_horizon,weiler_atherton,printed,mistakes}/*.h',
    '../../../lib/vidno/{corrected,printed}.h',
  ],
  { query: '?raw', import: 'default', eager: true },
);

/** A line of C++, its indentation apart. */
export interface SourceLine {
  readonly indent: number;
  readonly text: string;
}

/** The file of the library that holds a procedure, or the rules in which the editions differ. */
export interface Source {
  readonly path: string;
  readonly lines: readonly SourceLine[];
}

/** Where a procedure is not in the file of its name alone. */
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

/** The rules of an edition: those that are as usual, and what it has otherwise. */
function rulesOf(method: Method, edition: Edition): readonly string[] {
  const usual = [...(isFamily(method) ? ['family/family.h'] : []), 'corrected.h'];
  if (edition === 'corrected') return usual;
  if (edition === 'printed') return ['printed.h'];
  if (isMistake(edition)) return [...usual, mistakePath(edition)];
  return [...usual, method === 'zbuffer' ? 'printed/z_buffer_defects.h' : 'printed.h'];
}

/** The procedures of which the printed text as a whole is a single defect. */
const wholeDefects: Readonly<Record<string, string>> = {
  'surround_test.h': 'x-w4',
  'initialize_polygon.h': 'x-w6',
};

/** Whether an edition has a procedure as it is printed. */
const isAsPrinted = (file: string, edition: Edition): boolean =>
  edition === 'printed' || hasDefect(edition, wholeDefects[file] ?? '');

/** Whether a mistake has a procedure of its own, which does not ask for the usual one. */
function replaces(edition: Edition, procedure: string): boolean {
  if (!isMistake(edition)) return false;
  const text = texts[root + mistakePath(edition)] ?? '';
  return text.includes(` ${procedure}(auto& run`) && !text.includes(`Corrected::${procedure}(`);
}

/** The C++ of a run's procedures, in the order of their listings, and the rules of its edition. */
export function sourcesOf({
  method,
  edition,
}: Pick<Header, 'method' | 'edition'>): readonly Source[] {
  const folders = ['warnock/', 'z_buffer/', 'family/', 'floating_horizon/', 'weiler_atherton/'];
  const paths = namesOf(method)
    .flatMap(filesOf)
    .filter((file) => !replaces(edition, file.replace('.h', '')))
    .map((file) =>
      [...(isAsPrinted(file, edition) ? ['printed/'] : []), ...folders]
        .map((folder) => folder + file)
        .find((path) => root + path in texts),
    );
  return [...paths, ...rulesOf(method, edition)]
    .filter((path) => path !== undefined)
    .map((path) => ({ path, lines: linesOf(texts[root + path] ?? '') }));
}

/** Which lines of a source tell the event: those with its label, of several the ones that name the event. */
export function telling({ e, at }: Event, { lines }: Source): readonly number[] {
  const calls = new RegExp(`\\b(\\w+)\\((?:[^()]*\\W)?${at}\\b`, 'g');
  const found = lines.flatMap(({ text }, number) =>
    [...text.matchAll(calls)].map(([, called = '']) => ({ number, named: called.includes(e) })),
  );
  const named = found.filter((each) => each.named);
  return (named.length > 0 ? named : found).map(({ number }) => number);
}
