import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { CurveRun, Surface, SurfaceChart } from '../src/chart/surface-format.js';
import { browser } from './browser.js';
import { openChart, plot, rows, sampleText, surfaceSample, surfaceText, tabTo } from './chart.js';
import { compared, names } from './compare.js';
import { openFile, openUrl } from './page.js';

const built = pathToFileURL(fileURLToPath(new URL('../dist/index.html', import.meta.url))).href;

/** Kernel and samples of the runs on the front of missed height, as the file lists them. */
function expected({ runs }: Surface): readonly (readonly [string, string])[] {
  const on = runs.filter(({ front }) => front.samples.includes('height'));
  const sorted = [...on].sort((a: CurveRun, b: CurveRun) => a.samples - b.samples);
  return sorted.map(({ kernel, samples }) => [kernel, samples.toLocaleString('en')]);
}

/** The chart that the program wrote, if the test run provides it. */
const written = join(process.env['VIDNO_STATES'] ?? '', 'surface-chart.html');

describe.runIf(existsSync(written))('a page of a surface that the program wrote', () => {
  it('has tables that agree with the data in it, and leads to its runs', async () => {
    const html = readFileSync(written, 'utf8');
    const [, json] = /id="vidno-chart">(.*?)<\/script>/s.exec(html) ?? [];
    const { surfaces } = JSON.parse(json ?? '') as SurfaceChart;
    const { page, faults } = await openUrl(browser, `${pathToFileURL(written).href}#lang=en`);
    for (const surface of surfaces) {
      await page.locator('select').selectOption(`surfaces/${surface.name}`);
      await page.locator('input[value=samples]').check();
      await page.locator('input[value=height]').check();
      const found = (await rows(page)).map(([name, cost]) => [name?.split(',')[0], cost]);
      expect(found).toEqual(expected(surface));
    }
    await page.locator('vidno-front button').first().click();
    await page.locator('vidno-replay').getByRole('link', { name: 'Replay this run' }).waitFor();
    expect(faults).toEqual([]);
  });
});

describe('the chart of surfaces', () => {
  it('takes surface, cost and error by keyboard, and keeps them in the address', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', surfaceText);
    await plot(page).waitFor();
    await tabTo(page, 'select');
    await page.keyboard.press('ArrowDown');
    await page.waitForFunction(() => location.hash.includes('A+peak'));
    await tabTo(page, 'cost time');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await tabTo(page, 'error wrongColumns');
    await page.keyboard.press('ArrowRight');
    expect(new URL(page.url()).hash).toBe(
      '#lang=en&view=surfaces%2FA+peak+between+two+samples&cost=samples&error=height',
    );
    const found = await rows(page);
    // 2 samples for each of three curves miss the peak of 6 pixels, and 4 more on it are enough.
    expect(found.map((cells) => cells.slice(1))).toEqual([
      ['6', '6 px'],
      ['10', '0 px'],
    ]);
    const [peak] = surfaceSample.surfaces;
    expect(found.map(([name, cost]) => [name?.split(',')[0], cost])).toEqual(
      peak && expected(peak),
    );
    const { page: again } = await openChart(
      browser,
      new URL(page.url()).hash.slice(1),
      surfaceText,
    );
    await plot(again).waitFor();
    expect(await rows(again)).toEqual(found);
    expect(faults).toEqual([]);
  });

  it('describes each point by arrow keys, one after the other where runs coincide', async () => {
    const view = 'surfaces/Ramp <up> & down';
    const { page, faults } = await openChart(
      browser,
      `lang=en&cost=samples&view=${encodeURIComponent(view)}`,
      surfaceText,
    );
    await plot(page).waitFor();
    await page.locator('vidno-plot .canvas').focus();
    const said = page.locator('vidno-plot [aria-live]');
    const heard = new Set<string>();
    const count = surfaceSample.surfaces[1]?.runs.length ?? 0;
    await page.keyboard.press('Home');
    for (let i = 0; i < count; i++) {
      heard.add((await said.textContent()) ?? '');
      await page.keyboard.press('ArrowRight');
    }
    expect(heard.size).toBe(count);
    // Two curves over nine columns, each straight: two samples suffice.
    expect([...heard][0]).toBe(
      'float, 2 samples per curve; corrected; Samples: 4; Wrong columns: 0% (0 of 18)',
    );
    expect(faults).toEqual([]);
  });

  it('says which run is needed and why, in both languages', async () => {
    const { page, faults } = await openChart(
      browser,
      'lang=en&view=surfaces/A peak between two samples&cost=samples',
      surfaceText,
    );
    const about = page.locator('.about');
    // With even spacing, 17 samples per curve include the peak's corners: 51 instead of 10.
    expect(await about.innerText()).toMatch(
      /“filtered, tolerance 4 px”.*filtered, 17 samples.*×5\.1;/u,
    );
    await page.locator('vidno-languages [lang=ru]').click();
    await page.waitForFunction(() => document.documentElement.lang === 'ru');
    expect(await about.innerText()).toMatch(/«filtered, допуск 4\sпикс\.».*×5,1;/u);
    expect(await plot(page).textContent()).toContain('неверные столбцы');
    expect(faults).toEqual([]);
  });

  it('hides a kernel’s series', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', surfaceText);
    const points = page.locator('vidno-plot [aria-label=dot]').first().locator('path');
    await plot(page).waitFor();
    const before = await points.count();
    await page.locator('input[name=exact-tolerance]').focus();
    await page.keyboard.press('Space');
    await page.waitForFunction(() => location.hash.endsWith('hide=exact-tolerance'));
    // Nine tolerances, in both editions.
    expect(await points.count()).toBe(before - 18);
    expect(faults).toEqual([]);
  });

  it('links a point to its run with the same samples, alone and beside the exact run', async () => {
    const { page, faults } = await openChart(
      browser,
      'lang=en&view=surfaces/A peak between two samples&cost=samples',
      surfaceText,
      {},
      built,
    );
    await plot(page).waitFor();
    // The second run on the front has 10 samples in all.
    await page.locator('vidno-front button').nth(1).click();
    const panel = page.locator('vidno-replay');
    const replay = panel.getByRole('link', { name: 'Replay this run' });
    await replay.waitFor();
    const alone = await openUrl(browser, (await replay.getAttribute('href')) ?? '');
    await alone.page.locator('.title h2', { hasText: 'A peak between two samples' }).waitFor();
    const samples = await alone.page.evaluate(() => {
      const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
      const curves = player?.trace?.header.scene.curves ?? [];
      return curves.map((curve) => curve.map(([column]) => column));
    });
    expect(samples).toEqual([
      [0, 32],
      [0, 8, 10, 12, 16, 32],
      [0, 32],
    ]);
    const compare = panel.getByRole('link', { name: 'Compare with the exact run' });
    const beside = await openUrl(browser, (await compare.getAttribute('href')) ?? '');
    await compared(beside.page);
    expect(await names(beside.page)).toEqual([
      'Floating horizon · corrected · float',
      'Floating horizon · corrected · exact',
    ]);
    expect([...faults, ...alone.faults, ...beside.faults]).toEqual([]);
  });

  it('is replaced by a chart of scenes that is opened, and comes back', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&cost=samples', surfaceText);
    await plot(page).waitFor();
    await openFile(page, 'chart.json', sampleText);
    await page.locator('input[value=depthUlps]').waitFor();
    expect(await page.locator('input[value=time]').isChecked()).toBe(true);
    await openFile(page, 'surface-chart.json', surfaceText);
    await page.locator('input[value=samples]:checked').waitFor();
    expect(faults).toEqual([]);
  });
});
