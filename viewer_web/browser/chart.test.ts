import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { Scene, SceneChart, SceneRun } from '../src/chart/scene-format.js';
import { chartTexts } from '../src/i18n/chart.js';
import { browser } from './browser.js';
import { openChart, plot, rows, sample, sampleText, tabTo, template } from './chart.js';
import { openFile, openUrl } from './page.js';

const { methods } = chartTexts.en;

/** The Pareto front as the file lists it. */
function expected(scene: Scene | undefined): readonly (readonly [string, string])[] {
  const on = (scene?.runs ?? []).filter(({ front }) => front.operations.includes('area'));
  const sorted = [...on].sort(
    (a: SceneRun, b: SceneRun) => a.operations - b.operations || a.area - b.area,
  );
  return sorted.map(({ method, kernel, operations }) => [
    `${methods[method]} ${kernel}`,
    operations.toLocaleString('en'),
  ]);
}

/** The chart that the program wrote, if the test run provides it. */
const written = join(process.env['VIDNO_STATES'] ?? '', 'chart.html');

describe.runIf(existsSync(written))('a page that the program wrote', () => {
  it('has tables that agree with the data in it', async () => {
    const html = readFileSync(written, 'utf8');
    const [, json] = /id="vidno-chart">(.*?)<\/script>/s.exec(html) ?? [];
    const { scenes } = JSON.parse(json ?? '') as SceneChart;
    const { page, faults } = await openUrl(browser, `${pathToFileURL(written).href}#lang=en`);
    for (const scene of scenes) {
      await page.locator('select').selectOption(`${scene.kind}/${scene.name}`);
      await page.locator('input[value=operations]').check();
      await page.locator('input[value=area]').check();
      const costs = (await rows(page)).map(([, cost]) => cost);
      expect(costs).toEqual(expected(scene).map(([, cost]) => cost));
    }
    expect(faults).toEqual([]);
  });
});

describe('the chart', () => {
  it('takes scene, cost and error by keyboard, and keeps them in the address', async () => {
    const { page, faults } = await openChart(browser, 'lang=en');
    await plot(page).waitFor();
    await tabTo(page, 'select');
    await page.keyboard.press('ArrowDown');
    await page.waitForFunction(() => location.hash.includes('Two+walls'));
    await tabTo(page, 'cost time');
    await page.keyboard.press('ArrowRight');
    await tabTo(page, 'error wrongPixels');
    await page.keyboard.press('ArrowRight');
    expect(new URL(page.url()).hash).toBe(
      '#lang=en&view=ordinary%2FTwo+walls&cost=operations&error=area',
    );
    const found = await rows(page);
    expect(found.map(([name, cost]) => [name, cost])).toEqual(expected(sample.scenes[0]));
    const { page: again } = await openChart(browser, new URL(page.url()).hash.slice(1));
    await plot(again).waitFor();
    expect(await rows(again)).toEqual(found);
    expect(faults).toEqual([]);
  });

  it('has tables that agree with the file', async () => {
    const { page, faults } = await openChart(browser, 'lang=en');
    for (const scene of sample.scenes) {
      await page.locator('select').selectOption(`${scene.kind}/${scene.name}`);
      await page.locator('input[value=operations]').check();
      await page.locator('input[value=area]').check();
      const found = await rows(page);
      expect(found.map(([name, cost]) => [name, cost])).toEqual(expected(scene));
    }
    expect(faults).toEqual([]);
  });

  it('describes each point, by arrow keys and by mouse', async () => {
    const { page, faults } = await openChart(
      browser,
      'lang=en&view=ordinary/Two walls&cost=operations',
    );
    await plot(page).waitFor();
    await page.locator('vidno-plot .canvas').focus();
    const said = page.locator('vidno-plot [aria-live]');
    const heard = new Set<string>();
    const count = sample.scenes[0]?.runs.length ?? 0;
    await page.keyboard.press('Home');
    for (let i = 0; i < count; i++) {
      heard.add((await said.textContent()) ?? '');
      await page.keyboard.press('ArrowRight');
    }
    expect(heard.size).toBe(count);
    expect([...heard][0]).toMatch(
      /^Warnock double; smallest window: 16 px · corrected; Operations: 1,368; Wrong pixels: .*\(\d+ of 1,024\)$/,
    );
    expect(await page.locator('vidno-plot [aria-label=tip] path').count()).toBe(1);
    await page.keyboard.press('Escape');
    expect(await said.textContent()).toBe('');
    const [x, y] = await page
      .locator('vidno-plot [aria-label=dot] path')
      .first()
      .evaluate((dot) => {
        const { left, right, top, bottom } = dot.getBoundingClientRect();
        return [(left + right) / 2, (top + bottom) / 2] as const;
      });
    await page.mouse.move(x, y);
    await page.locator('vidno-plot [aria-label=tip] text').waitFor();
    expect(faults).toEqual([]);
  });

  it('shows a row’s point', async () => {
    const { page } = await openChart(browser, 'lang=en');
    const button = page.locator('vidno-front button').nth(1);
    await button.focus();
    await page.locator('vidno-front tr[aria-current=true]').waitFor();
    expect(await page.locator('vidno-plot [aria-live]').textContent()).toContain(
      (await button.textContent())?.trim(),
    );
  });

  it('hides a series, and remembers that', async () => {
    const { page, faults } = await openChart(browser, 'lang=en');
    const points = page.locator('vidno-plot [aria-label=dot]').first().locator('path');
    await plot(page).waitFor();
    const before = await points.count();
    await page.locator('input[name=warnock-bits]').focus();
    await page.keyboard.press('Space');
    await page.waitForFunction(() => location.hash.endsWith('hide=warnock-bits'));
    const after = await points.count();
    expect(after).toBeLessThan(before);
    const { page: again } = await openChart(browser, new URL(page.url()).hash.slice(1));
    await plot(again).waitFor();
    expect(await again.locator('input[name=warnock-bits]').isChecked()).toBe(false);
    expect(faults).toEqual([]);
  });

  it('speaks both languages', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&view=degenerate/Slivers');
    await plot(page).waitFor();
    expect(await page.locator('main').innerText()).not.toMatch(/[а-я]/);
    await page.locator('vidno-languages [lang=ru]').click();
    await page.waitForFunction(() => document.documentElement.lang === 'ru');
    expect(await plot(page).textContent()).toContain('неверные пиксели');
    expect(await page.locator('main').innerText()).toMatch(/[а-я]/);
    expect(new URL(page.url()).hash).toContain('lang=ru&view=degenerate');
    expect(faults).toEqual([]);
  });
});

describe('a file of the reader’s own', () => {
  it('is requested by a page built without data, and opened', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', 'null');
    expect(await page.locator('code').textContent()).toBe('vidno chart SCENE... -o chart.html');
    await openFile(page, 'chart.json', sampleText);
    await plot(page).waitFor();
    expect(faults).toEqual([]);
  });

  it.each([
    ['text.json', 'hello', /this is not JSON: "hello"/],
    [
      '<img src=x onerror=alert(1)>.json',
      '',
      /<img src=x onerror=alert\(1\)> *\.json.*the file is empty/,
    ],
    ['trace.json', '{"format":"vidno-trace/1"}', /format: vidno-chart\/1 is expected here/],
    ['none.json', '{"format":"vidno-chart/1","rounds":1,"scenes":[]}', /scenes: the list is empty/],
    [
      'part.json',
      sampleText.replace('"pixels"', '"pixel"'),
      /scenes\[0\]\.pixels: this field is missing/,
    ],
    ['huge.json', sampleText.replace('"rounds":5', '"rounds":1e999'), /rounds: a whole number/],
  ])('%s is refused in one line, and the chart stays', async (name, content, message) => {
    const { page, faults } = await openChart(browser, 'lang=en');
    await plot(page).waitFor();
    await openFile(page, name, content);
    await page.locator('p.failed').waitFor();
    expect(await page.locator('p.failed').innerText()).toMatch(message);
    expect(await plot(page).count()).toBe(1);
    await openFile(page, 'chart.json', sampleText);
    await page.locator('p.failed').waitFor({ state: 'detached' });
    expect(faults).toEqual([]);
  });

  it('is shown by a page that names all packages in it, and their licences', () => {
    for (const name of ['lit-html', '@observablehq/plot', 'd3-scale', 'ColorBrewer', 'Karney']) {
      expect(template.slice(template.lastIndexOf('<!--'))).toContain(name);
    }
  });

  it('shows markup as text, and numbers however large', async () => {
    const evil = '</script><img src=x onerror=alert(1)>';
    const json = sampleText
      .replaceAll('Two walls', evil)
      .replaceAll('"exact"', JSON.stringify(evil))
      .replace(/"time":[\d.]+/, '"time":1e308')
      .replace(/"time":[\d.]+,/, '"time":5e-324,')
      .replace(/"area":[\d.]+,"decisions"/, '"area":1e308,"decisions"');
    const { page, faults } = await openChart(
      browser,
      `lang=en&view=ordinary/${evil}&error=area`,
      json,
    );
    await plot(page).waitFor();
    expect(await plot(page).textContent()).toContain('<img');
    expect(await page.locator('img').count()).toBe(0);
    expect(faults).toEqual([]);
  });

  it('says what is wrong with the block of data', async () => {
    const { page } = await openChart(browser, 'lang=ru', '{"format":1}');
    expect(await page.locator('p.failed').innerText()).toMatch(
      /^Файл chart\.html нельзя прочитать/,
    );
  });
});
