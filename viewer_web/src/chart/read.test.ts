import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { sample, sampleText } from '../testing/charts.js';
import { isRefusal } from '../trace/refusal.js';
import type { Reason } from '../trace/refusal.js';
import { sceneCosts, sceneErrors, sceneKinds, sceneKnobs } from './scene-format.js';
import { readChart } from './format.js';
import { fileOf, subjectsOf } from './subject.js';

async function refused(content: BlobPart): Promise<readonly [string, Reason]> {
  const error: unknown = await readChart(new Blob([content])).then(
    () => null,
    (thrown: unknown) => thrown,
  );
  if (!isRefusal(error)) throw new Error('It was taken.');
  return [error.path, error.reason];
}

describe('a chart', () => {
  it('may hold its scenes, each an object', async () => {
    const [first] = sample.scenes;
    const scene = { format: 'vidno-scene/1', name: 'Two' };
    const withScene = (value: unknown): string =>
      JSON.stringify({ ...sample, scenes: [{ ...first, scene: value }] });
    const chart = await readChart(new Blob([withScene(scene)]));
    expect(subjectsOf(chart).map(fileOf)[0]).toEqual(scene);
    expect(await refused(withScene('Two'))).toEqual(['scenes[0].scene', 'object']);
  });

  it('is read unchanged', async () => {
    const chart = await readChart(new Blob([sampleText]));
    const written = JSON.stringify(chart, (_key, value: unknown) =>
      value === Infinity ? 'inf' : value,
    );
    expect(JSON.parse(written)).toEqual(JSON.parse(sampleText));
  });

  it.each<[string, Buffer]>([
    ['UTF-8', Buffer.from(`\ufeff${sampleText}`)],
    ['UTF-16, little-endian', Buffer.from(`\ufeff${sampleText}`, 'utf16le')],
    ['UTF-16, big-endian', Buffer.from(`\ufeff${sampleText}`, 'utf16le').swap16()],
  ])('may be in %s with a byte order mark, as Windows editors write it', async (_name, bytes) => {
    expect(await readChart(new Blob([new Uint8Array(bytes)]))).toEqual(sample);
  });

  it('of the tests has every possible field', () => {
    const runs = sample.scenes.flatMap((scene) => scene.runs);
    expect(new Set(sample.scenes.map(({ kind }) => kind))).toEqual(new Set(sceneKinds));
    expect(new Set(runs.map(({ knob }) => knob))).toEqual(new Set([...sceneKnobs, null]));
    expect(runs.some(({ bits }) => bits === null)).toBe(true);
    expect(runs.some(({ depthUlps }) => depthUlps === Infinity)).toBe(true);
    for (const cost of sceneCosts) {
      for (const error of sceneErrors) {
        expect(runs.some(({ front }) => front[cost].includes(error))).toBe(true);
      }
    }
  });

  it('may have more fields than the page knows', async () => {
    const more = sampleText.replace('"rounds":5', '"rounds":5,"host":"x"');
    expect(await readChart(new Blob([more]))).toEqual(sample);
  });
});

/** The sample with the first occurrence of a text replaced. */
const but = (found: string | RegExp, by: string): string => {
  const changed = sampleText.replace(found, by);
  if (changed === sampleText) throw new Error('Nothing was replaced.');
  return changed;
};

const bad: readonly (readonly [string, BlobPart, string, Reason])[] = [
  ['nothing', '', '', 'emptyFile'],
  ['no JSON', 'hello', '', 'notJson'],
  ['half of one', sampleText.slice(0, 3000), '', 'notJson'],
  ['not UTF-8', new Uint8Array([0x7b, 0xff, 0xfe]), '', 'notUtf8'],
  ['null', 'null', '', 'object'],
  ['a list', '[]', '', 'object'],
  ['a number', '1e400', '', 'object'],
  ['brackets without end', '['.repeat(100_000), '', 'notJson'],
  ['a trace', '{"format":"vidno-trace/1"}', 'format', 'oneOf'],
  ['a later format', but('chart/1', 'chart/2'), 'format', 'newerFormat'],
  ['no scenes', '{"format":"vidno-chart/1","rounds":5}', 'scenes', 'missing'],
  ['empty scenes', '{"format":"vidno-chart/1","rounds":5,"scenes":[]}', 'scenes', 'emptyList'],
  ['scenes by name', '{"format":"vidno-chart/1","rounds":5,"scenes":{}}', 'scenes', 'list'],
  ['no runs', but('"runs"', '"walks"'), 'scenes[0].runs', 'missing'],
  ['a scene without pixels', but('"pixels":1024', '"pixels":0'), 'scenes[0].pixels', 'between'],
  ['a name that is none', but('"Two walls"', 'null'), 'scenes[0].name', 'text'],
  ['another kind', but('"ordinary"', '"odd"'), 'scenes[0].kind', 'oneOf'],
  ['an unknown method', but('"warnock"', '"__proto__"'), 'scenes[0].runs[0].method', 'oneOf'],
  ['a text for a time', but(/"time":[\d.]+/, '"time":"fast"'), 'scenes[0].runs[0].time', 'number'],
  ['a time before', but(/"time":[\d.]+/, '"time":-1'), 'scenes[0].runs[0].time', 'notNegative'],
  ['no time', but(/"time":[\d.]+,/, ''), 'scenes[0].runs[0].time', 'missing'],
  ['too long', but(/"time":[\d.]+/, '"time":1e999'), 'scenes[0].runs[0].time', 'number'],
  [
    'half a pixel',
    but(/"wrongPixels":\d+/, '"wrongPixels":0.5'),
    'scenes[0].runs[0].wrongPixels',
    'whole',
  ],
  ['too many', but(/"decisions":\d+/, '"decisions":1e17'), 'scenes[0].runs[0].decisions', 'whole'],
  [
    'no number',
    but(/"depthUlps":[\d.]+/, '"depthUlps":"nan"'),
    'scenes[0].runs[0].depthUlps',
    'number',
  ],
  [
    'an unknown error',
    but(/"front":\{"time":\[[^\]]*/, '"front":{"time":["x"'),
    'scenes[0].runs[0].front.time[0]',
    'oneOf',
  ],
  [
    'a knob without its value',
    but('"knob":"bits","value":4', '"knob":"bits","value":null'),
    'scenes[0].runs[7].value',
    'whole',
  ],
];

describe('an invalid chart is refused with place and reason', () => {
  it.each(bad)('%s', async (_name, content, path, reason) => {
    expect(await refused(content)).toEqual([path, reason]);
  });
});

const schema = fileURLToPath(new URL('../../../trace/schema/chart.schema.json', import.meta.url));

describe.runIf(existsSync(schema))('the schema of the repository', () => {
  const ajv = new Ajv2020({ strict: false });
  const validate = ajv.compile(JSON.parse(readFileSync(schema, 'utf8')) as object);
  const errorsOf = (text: string): unknown => validate(JSON.parse(text)) || validate.errors;

  it('agrees with the sample', () => {
    expect(errorsOf(sampleText)).toBe(true);
  });

  it.each([
    but('"rounds":5', '"rounds":5,"host":"x"'),
    but(/"bits":\d+/, '"bits":"inf"'),
    but('"knob":null,"value":null', '"knob":null,"value":3'),
    but('"knob":"bits","value":4', '"knob":"bits","value":null'),
  ])('refuses what no program writes (%#)', (text) => {
    expect(errorsOf(text)).not.toBe(true);
  });
});
