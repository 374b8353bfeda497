import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { runName } from './run-name.js';

const folder = new URL('../../../lessons/', import.meta.url);
interface Written {
  readonly runs?: readonly {
    readonly name: string;
    readonly title?: Record<'en' | 'ru', string>;
  }[];
}

const runs = readdirSync(fileURLToPath(folder))
  .filter((name) => /^\d\d-/u.test(name))
  .flatMap((lesson) => {
    const text = readFileSync(new URL(`${lesson}/lesson.json`, folder), 'utf8');
    return ((JSON.parse(text) as Written).runs ?? []).map((run) => ({ lesson, ...run }));
  });

const run = {
  file: '03-subdivision.triangle-32.warnock.float.corrected.windows.jsonl.gz',
  method: 'warnock',
  kernel: 'float',
  edition: 'corrected',
  detail: 'windows',
} as const;

it('names a run by its title, and adds its settings', () => {
  const title = { en: 'A triangle', ru: 'Треугольник' };
  const name = { ...run, title };
  expect(runName(name, texts.en.page, 'en')).toEqual({
    title: 'A triangle',
    way: 'Warnock, float',
  });
  expect(runName(name, texts.ru.page, 'ru').title).toBe('Треугольник');
});

it('names a run without a title by its settings, never by its file', () => {
  expect(runName(run, texts.en.page, 'en').title).toBe('Warnock, float');
});

it('finds a title of each run of the lessons, in both languages', () => {
  expect(runs.length).toBeGreaterThan(70);
  const untold = runs.filter(
    ({ title }) => title === undefined || title.en === '' || !/\p{Script=Cyrillic}/u.test(title.ru),
  );
  expect(untold).toEqual([]);
});

it('gives no two runs of a lesson the same name', () => {
  const names = runs.map(({ lesson, title }) => `${lesson}: ${title?.en}`);
  expect(names.filter((name, i) => names.indexOf(name) !== i)).toEqual([]);
});
