import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { runName } from './run-name.js';

const folder = new URL('../../../lessons/', import.meta.url);
interface Written {
  readonly runs?: readonly { readonly scene?: string }[];
}

/** The scenes that the lessons name, as the names of the runs have them. */
const scenes = readdirSync(fileURLToPath(folder))
  .filter((name) => /^\d\d-/u.test(name))
  .flatMap((lesson) => {
    const text = readFileSync(new URL(`${lesson}/lesson.json`, folder), 'utf8');
    return ((JSON.parse(text) as Written).runs ?? []).flatMap(({ scene }) => scene ?? []);
  })
  .map((scene) => scene.replace(/^.*\/|\.[a-z]+$/gu, ''))
  .filter((scene) => scene !== 'scene');

it('names the scene of a run in the language of the page', () => {
  const run = {
    file: '03-subdivision.triangle-32.warnock.float.corrected.windows.jsonl.gz',
    method: 'warnock',
    kernel: 'float',
    edition: 'corrected',
    detail: 'windows',
    scene: 'triangle-32',
  } as const;
  expect(runName(run, texts.en.page)).toEqual({ method: 'Warnock', variant: 'float, triangle 32' });
  expect(runName(run, texts.ru.page).variant).toBe('float, треугольник 32');
});

it('knows a Russian name for each scene of the lessons', () => {
  expect(scenes.length).toBeGreaterThan(20);
  expect(scenes.filter((scene) => /\p{Script=Latin}/u.test(texts.ru.page.scene(scene)))).toEqual(
    [],
  );
});
