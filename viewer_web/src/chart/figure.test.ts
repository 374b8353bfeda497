import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { chartTexts } from '../i18n/chart.js';
import { sample, surfaceSample } from '../testing/charts.js';
import { mainOf } from './main.js';
import { pointsOf } from './points.js';
import { settingId } from './series.js';
import { axesOf } from './subject.js';

const program = process.env['VIDNO_PROGRAM'] ?? '';

/** The texts of the program's figure of a chart. */
function textsOf(chart: unknown, cost: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'vidno-'));
  try {
    const file = join(folder, 'chart.json');
    writeFileSync(
      file,
      JSON.stringify(chart, (_, value: unknown) => (value === Infinity ? 'inf' : value)),
    );
    const svg = execFileSync(program, ['figure', file, '--cost', cost, '-o', '-'], {
      encoding: 'utf8',
    });
    return [...svg.matchAll(/<text[^>]*>([^<]*)/gu)].map(([, text]) => text).join(' ');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const charts = [
  ...sample.scenes.map((scene) => ({ subject: scene, chart: { ...sample, scenes: [scene] } })),
  ...surfaceSample.surfaces.map((surface) => ({
    subject: surface,
    chart: { ...surfaceSample, surfaces: [surface] },
  })),
];

describe.skipIf(program === '')('the figure that the program draws of a chart', () => {
  it.each(
    charts.flatMap(({ subject, chart }) =>
      axesOf([subject]).costs.map((cost) => [subject.name, cost, subject, chart] as const),
    ),
  )('of %s by %s names the runs that the page opens with', (_name, cost, subject, chart) => {
    const { ids, cheapest } = mainOf([subject], cost);
    const [error] = axesOf([subject]).errors;
    const kernels = pointsOf([subject], cost, error)
      .points.filter(({ setting }) => ids.has(settingId(setting)))
      .map(({ setting }) => setting.kernel);
    const texts = textsOf(chart, cost);
    const named = texts.match(/\b(?:float|double|filtered|exact)\b/gu) ?? [];
    expect([...named].sort()).toEqual([...kernels].sort());
    expect(texts.includes(chartTexts.en.cheapestMark)).toBe(cheapest !== null);
  });
});
