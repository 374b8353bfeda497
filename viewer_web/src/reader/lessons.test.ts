import { Ajv2020 } from 'ajv/dist/2020.js';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const top = fileURLToPath(new URL('../../../', import.meta.url));
const read = (file: string): unknown => JSON.parse(readFileSync(top + file, 'utf8'));

const lessons = readdirSync(`${top}lessons`)
  .map((name) => `lessons/${name}/lesson.json`)
  .filter((file) => existsSync(top + file));

describe('the lessons of the repository', () => {
  const fits = new Ajv2020().compile(read('trace/schema/lesson.schema.json') as object);

  it.each(lessons)('%s fits its schema', (file) => {
    fits(read(file));
    expect(fits.errors ?? []).toEqual([]);
  });

  it('refuses a lesson without a run', () => {
    expect(fits({ format: 'vidno-lesson/1', runs: [], pins: {} })).toBe(false);
  });
});
