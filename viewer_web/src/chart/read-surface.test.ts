import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { surfaceSample, surfaceText } from '../testing/charts.js';
import { isRefusal } from '../trace/refusal.js';
import type { Reason } from '../trace/refusal.js';
import { readChart } from './format.js';
import { curveKernels, curveKnobs } from './surface-format.js';

/** The sample with the first occurrence of a text replaced. */
const but = (found: string | RegExp, by: string): string => {
  const changed = surfaceText.replace(found, by);
  if (changed === surfaceText) throw new Error('Nothing was replaced.');
  return changed;
};

describe('a chart of surfaces', () => {
  it('is read unchanged, each surface with its file', async () => {
    const chart = await readChart(new Blob([surfaceText]));
    expect(chart).toEqual(JSON.parse(surfaceText));
    const withoutFile = but(/"surface":\{.*?\},"runs"/u, '"runs"');
    expect(await readChart(new Blob([withoutFile]))).toHaveProperty('surfaces[0].columns', 99);
  });

  it('of the tests has each kernel, and each knob', () => {
    const runs = surfaceSample.surfaces.flatMap((surface) => surface.runs);
    expect(new Set(runs.map(({ kernel }) => kernel))).toEqual(new Set(curveKernels));
    expect(new Set(runs.map(({ knob }) => knob))).toEqual(new Set([...curveKnobs, null]));
  });

  const run = 'surfaces[0].runs[0]';
  it.each<readonly [string, string, string, Reason]>([
    ['no surfaces', '{"format":"vidno-chart/1","rounds":5,"surfaces":[]}', 'surfaces', 'emptyList'],
    ['no columns', but('"columns":99', '"columns":0'), 'surfaces[0].columns', 'between'],
    ['a method of scenes', but('"floating-horizon"', '"warnock"'), `${run}.method`, 'oneOf'],
    ['a kernel with bits', but('"float"', '"bits:8"'), `${run}.kernel`, 'oneOf'],
    ['an unknown knob', but('"knob":null', '"knob":"grid"'), `${run}.knob`, 'oneOf'],
    ['a knob turned nowhere', but('"knob":null', '"knob":"samples"'), `${run}.value`, 'number'],
    ['a height below', but(/"height":6\.0/u, '"height":-1'), `${run}.height`, 'notNegative'],
    ['half a sample', but('"samples":27', '"samples":0.5'), `${run}.samples`, 'whole'],
    [
      'a text for a file',
      but(/"surface":\{.*?\},"runs"/u, '"surface":"x","runs"'),
      'surfaces[0].surface',
      'object',
    ],
  ])('is refused with place and reason: %s', async (_name, content, path, reason) => {
    const error: unknown = await readChart(new Blob([content])).catch((thrown: unknown) => thrown);
    if (!isRefusal(error)) throw new Error('It was taken.');
    expect([error.path, error.reason]).toEqual([path, reason]);
  });
});

const schema = fileURLToPath(new URL('../../../trace/schema/chart.schema.json', import.meta.url));

describe.runIf(existsSync(schema))('the schema of the repository', () => {
  const validate = new Ajv2020({ strict: false }).compile(
    JSON.parse(readFileSync(schema, 'utf8')) as object,
  );

  it('agrees with the sample', () => {
    expect(validate(JSON.parse(surfaceText)) || validate.errors).toBe(true);
  });

  it.each([
    but('"columns":99', '"columns":0'),
    but(/"surface":\{.*?\},"runs"/u, '"surface":"x","runs"'),
  ])('refuses what no program writes (%#)', (text) => {
    expect(validate(JSON.parse(text))).toBe(false);
  });
});
