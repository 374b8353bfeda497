import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { SurfaceChart } from '../src/chart/surface-format.js';
import { browser } from './browser.js';
import { dots, openChart, plot, rows, sampleText, surfaceText, tabTo } from './chart.js';
import { compared, names } from './compare.js';
import { openFile, openUrl } from './page.js';

const built = pathToFileURL(fileURLToPath(new URL('../dist/index.html', import.meta.url))).href;

/** The chart that the program wrote, if the test run provides it. */
const written = join(process.env['VIDNO_STATES'] ?? '', 'surface-chart.html');

describe.runIf(existsSync(written))('a page of a surface that the program wrote', () => {
  it('has tables that agree with the data in it, and leads to its runs', async () => {
    const html = readFileSync(written, 'utf8');
    const [, json] = /id="vidno-chart">(.*?)<\/script>/s.exec(html) ?? [];
    const { surfaces } = JSON.parse(json ?? '') as SurfaceChart;
    const { page, faults } = await openUrl(browser, `${pathToFileURL(written).href}#lang=en`);
    for (const surface of surfaces) {
      await page.locator('select[name=view]').selectOption(`surfaces/${surface.name}`);
      await page.locator('input[value=samples]').check();
      await page.locator('input[value=height]').check();
      const found = (await rows(page)).map(([, cost]) => Number(cost?.replaceAll(',', '')));
      expect(found.length).toBeLessThanOrEqual(12);
      expect(surface.runs.map(({ samples }) => samples)).toEqual(expect.arrayContaining(found));
    }
    await page.locator('vidno-advice button').first().click();
    await page.locator('vidno-panel').getByRole('link', { name: 'Replay this run' }).waitFor();
    expect(faults).toEqual([]);
  });
});

describe('the chart of surfaces', () => {
  it('takes surface, cost and error by keyboard, and keeps them in the address', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', surfaceText);
    await plot(page).waitFor();
    await tabTo(page, 'select view');
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
    // The file gives 9 samples for each of three curves. 4 samples more than at their ends are enough. Even spacing needs 17 for each, and each column has 33.
    const costs = new Set(found.map(([, cost]) => cost));
    expect(costs).toEqual(new Set(['10', '27', '51', '99']));
    expect(found.length).toBe(10);
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
    await page.keyboard.press('Home');
    for (let i = 0; i < 20; i++) {
      heard.add((await said.textContent()) ?? '');
      await page.keyboard.press('ArrowRight');
    }
    const all = await rows(page);
    expect(heard.size).toBe(all.length);
    expect([...heard].every((each) => each.includes('Wrong columns: 0% (0 of 18)'))).toBe(true);
    expect(faults).toEqual([]);
  });

  it('says which run is needed and why, in both languages', async () => {
    const { page, faults } = await openChart(
      browser,
      'lang=en&view=surfaces/A peak between two samples&cost=samples',
      surfaceText,
    );
    const advice = page.locator('vidno-advice p');
    expect(await advice.innerText()).toMatch(/filtered, tolerance 4 px is the cheapest right run/u);
    await page.locator('vidno-languages [lang=ru]').click();
    await page.waitForFunction(() => document.documentElement.lang === 'ru');
    expect(await advice.innerText()).toMatch(/filtered, допуск 4\sпикс\. — самый дешёвый/u);
    expect(await plot(page).textContent()).toContain('доля неверных столбцов');
    expect(faults).toEqual([]);
  });

  it('adds a kernel’s series', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', surfaceText);
    await plot(page).waitFor();
    await page.locator('select[name=series]').selectOption('exact-tolerance');
    await page.waitForFunction(() => location.hash.endsWith('series=exact-tolerance'));
    // Nine tolerances, in both editions.
    expect((await dots(page, 'added')).length).toBe(18);
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
    // The cheapest right run has 10 samples in all.
    await page.locator('vidno-advice button').first().click();
    const panel = page.locator('vidno-panel');
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
      'Floating horizon · corrected · filtered',
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
