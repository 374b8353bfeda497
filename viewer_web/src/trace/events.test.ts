import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { textOf, traceNames } from '../testing/traces.js';
import { allSamples } from '../testing/samples.js';

const schemaFile = (name: string): string =>
  fileURLToPath(new URL(`../../../trace/schema/${name}.schema.json`, import.meta.url));

describe.runIf(existsSync(schemaFile('trace')))('the schema of the repository', () => {
  const ajv = new Ajv2020({ strict: false });
  for (const name of ['scene', 'surface', 'trace']) {
    if (existsSync(schemaFile(name))) {
      ajv.addSchema(JSON.parse(readFileSync(schemaFile(name), 'utf8')) as object, name);
    }
  }
  const validate = (line: unknown): unknown => ajv.validate('trace', line) || ajv.errors;

  it.each(traceNames)('agrees with %s', (name) => {
    for (const line of textOf(name).trim().split('\n')) {
      expect([line, validate(JSON.parse(line))]).toEqual([line, true]);
    }
  });

  it.each(allSamples.map((event) => [event.e, event] as const))(
    'agrees with %s',
    (_name, event) => {
      expect(validate(event)).toBe(true);
    },
  );
});
