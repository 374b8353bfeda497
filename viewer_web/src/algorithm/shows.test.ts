import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { stateParts } from './shows.js';

interface Schema {
  readonly properties: { readonly shows: { readonly items: { readonly enum: readonly string[] } } };
}

const read = (file: string): string =>
  readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

it('has the parts of the state that a lesson may name, by schema and program', () => {
  const schema = JSON.parse(read('trace/schema/lesson.schema.json')) as Schema;
  expect(schema.properties.shows.items.enum).toEqual(stateParts);
  const [, list = ''] = /state_parts\{([^}]*)\}/.exec(read('trace/lesson/lesson.h')) ?? [];
  expect([...list.matchAll(/"([^"]+)"/g)].map(([, name]) => name)).toEqual(stateParts);
});

it('is a part of the panel of some algorithm', () => {
  const panels = ['warnock', 'zbuffer', 'weiler-atherton', 'floating-horizon'].map((algorithm) =>
    read(`viewer_web/src/${algorithm}/panel.ts`),
  );
  const missing = stateParts.filter(
    (part) => !panels.some((panel) => panel.includes(`data-part="${part}"`)),
  );
  expect(missing).toEqual([]);
});
