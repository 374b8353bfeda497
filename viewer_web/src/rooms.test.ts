import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';
import { expect, it } from 'vitest';

/**
 * The folders of the page, in their order of dependency: a file imports only from its own folder and from earlier ones.
 * The code shared by all algorithms comes before them, and refers to them only by the interface in `algorithm/`.
 */
const rooms = [
  'base',
  'trace',
  'language',
  'i18n/en',
  'i18n/ru',
  'i18n',
  'lessons',
  'replay',
  'algorithm',
  'elements',
  'picture',
  'exactness',
  'time',
  'history',
  'strip',
  'listing',
  'outline',
  'predict',
  'solid',
  'run',
  'editor',
  'polygons',
  'chart',
  'chart/page',
  'warnock',
  'zbuffer',
  'weiler-atherton',
  'floating-horizon',
  'player',
  'compare',
  'atlas',
  'reader',
  'app',
];

/** These folders refer to types of later folders: texts for each name, and the parts of an algorithm. */
const mayNameTypes = ['language', 'i18n', 'i18n/en', 'algorithm'];

const source = fileURLToPath(new URL('.', import.meta.url));

const files = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter(
  (file) =>
    file.endsWith('.ts') &&
    !/\.(test|d)\.ts$/.test(file) &&
    dirname(file) !== 'testing' &&
    !file.startsWith('testing/'),
);

interface Import {
  readonly from: string;
  readonly to: string;
  readonly isType: boolean;
}

/** The imports of a file from other folders of the page, except for the script of a worker, which is a separate program. */
function importsOf(file: string): readonly Import[] {
  const text = readFileSync(join(source, file), 'utf8');
  const parsed = ts.createSourceFile(file, text, ts.ScriptTarget.ESNext);
  return parsed.statements.flatMap((statement) => {
    if (!ts.isImportDeclaration(statement) && !ts.isExportDeclaration(statement)) return [];
    const { moduleSpecifier } = statement;
    if (moduleSpecifier === undefined || !ts.isStringLiteral(moduleSpecifier)) return [];
    const path = moduleSpecifier.text;
    if (!path.startsWith('.') || path.endsWith('?code')) return [];
    const to = dirname(normalize(join(dirname(file), path)));
    const isType = /^(import|export) type\b/.test(statement.getText(parsed));
    return [{ from: file, to, isType }];
  });
}

const imports = files.flatMap(importsOf).filter(({ to }) => !to.startsWith('..'));

it('each file of the page is in a room', () => {
  expect(files.filter((file) => !rooms.includes(dirname(file)))).toEqual([]);
});

it('each room uses only itself and the rooms before it', () => {
  const wrong = imports.filter(
    ({ from, to, isType }) =>
      rooms.indexOf(to) > rooms.indexOf(dirname(from)) &&
      !(isType && mayNameTypes.includes(dirname(from))),
  );
  expect(wrong.map(({ from, to }) => `${from} uses ${to}`)).toEqual([]);
});
