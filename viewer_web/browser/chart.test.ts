import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { Scene, SceneChart, SceneRun } from '../src/chart/scene-format.js';
import { browser } from './browser.js';
import {
  dots,
  openChart,
  overlapping,
  plot,
  rows,
  sample,
  sampleText,
  tabTo,
  template,
  textsIn,
} from './chart.js';
import { openFile, openUrl } from './page.js';

const compared = ['float', 'double', 'filtered', 'exact'];

/** The runs that the chart opens with, as the file lists them, by operations. */
function expected(scene: Scene | undefined): readonly (readonly [string, string])[] {
  const runs = (scene?.runs ?? []).filter(
    ({ kernel, knob, edition, complete }) =>
      complete && knob === null && edition === 'corrected' && compared.includes(kernel),
  );
  const isOfCourse = ({ method }: SceneRun): boolean => ['zbuffer', 'warnock'].includes(method);
  const right = runs
    .filter((run) => !isOfCourse(run) && run.wrongPixels === 0)
    .map(({ operations }) => operations);
  const costs = runs.filter(isOfCourse).map(({ operations }) => operations);
  const all = [...costs, ...(right.length === 0 ? [] : [Math.min(...right)])];
  return all.sort((a, b) => a - b).map((cost) => ['', cost.toLocaleString('en')]);
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
      await page.locator('select[name=view]').selectOption(`${scene.kind}/${scene.name}`);
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
    await tabTo(page, 'select view');
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
    expect(found.map(([, cost]) => cost)).toEqual(
      expected(sample.scenes[0]).map(([, cost]) => cost),
    );
    const { page: again } = await openChart(browser, new URL(page.url()).hash.slice(1));
    await plot(again).waitFor();
    expect(await rows(again)).toEqual(found);
    expect(faults).toEqual([]);
  });

  it('has tables that agree with the file', async () => {
    const { page, faults } = await openChart(browser, 'lang=en');
    for (const scene of sample.scenes) {
      await page.locator('select[name=view]').selectOption(`${scene.kind}/${scene.name}`);
      await page.locator('input[value=operations]').check();
      await page.locator('input[value=area]').check();
      const found = await rows(page);
      expect(found.map(([, cost]) => cost)).toEqual(expected(scene).map(([, cost]) => cost));
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
    const count = expected(sample.scenes[0]).length;
    await page.keyboard.press('Home');
    for (let i = 0; i < count; i++) {
      heard.add((await said.textContent()) ?? '');
      await page.keyboard.press('ArrowRight');
    }
    expect(heard.size).toBe(count);
    expect([...heard][0]).toMatch(/^\S.*; Operations: [\d,]+; Wrong pixels: .*\(\d+ of 1,024\)$/u);
    expect(await page.locator('vidno-plot [aria-label=tip] path').count()).toBe(1);
    await page.keyboard.press('Escape');
    expect(await said.textContent()).toBe('');
    const [[x, y] = [0, 0]] = await dots(page, 'main');
    await page.mouse.move(x, y);
    await page.locator('vidno-plot [aria-label=tip] text').waitFor();
    expect(faults).toEqual([]);
  });

  it('shows a row’s point', async () => {
    const { page } = await openChart(browser, 'lang=en');
    await page.locator('vidno-points summary').click();
    const button = page.locator('vidno-points button').nth(1);
    await button.focus();
    await page.locator('vidno-points tr[aria-current=true]').waitFor();
    expect(await page.locator('vidno-plot [aria-live]').textContent()).toContain(
      (await button.textContent())?.trim(),
    );
  });

  it('opens with one question, and at most twelve points, the wrong ones above those on one line', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&view=degenerate/Slivers');
    await plot(page).waitFor();
    expect(await page.locator('main h2').first().textContent()).toBe(
      'What does a right picture cost?',
    );
    await page.locator('vidno-points summary').click();
    const wrong = await page
      .locator('vidno-points tbody tr')
      .evaluateAll((all) =>
        all.map((row) => !(row.lastElementChild?.textContent.trim() ?? '').startsWith('0%')),
      );
    const points = await dots(page, 'main');
    expect(points.length).toBe(wrong.length);
    expect(points.length).toBeLessThanOrEqual(12);
    const divide = await page
      .locator('vidno-plot .canvas [aria-description=divide] line')
      .evaluate((line) => line.getBoundingClientRect().top);
    const below = points.map(([, y]) => y).filter((y) => y > divide);
    expect(below.length).toBe(wrong.filter((is) => !is).length);
    expect(Math.max(...below) - Math.min(...below)).toBeLessThan(1);
    expect(await page.locator('vidno-plot .canvas [aria-description=cheapest] > *').count()).toBe(
      1,
    );
    expect(await page.locator('vidno-advice tbody tr').count()).toBe(3);
    expect(faults).toEqual([]);
  });

  it('adds a series by keyboard, fades the rest, and remembers that', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&view=ordinary/Two walls');
    await plot(page).waitFor();
    const strength = (of: string): Promise<string | null> =>
      page.locator(`vidno-plot .canvas [aria-description="${of} points"]`).getAttribute('opacity');
    expect(await dots(page, 'added')).toEqual([]);
    expect(await strength('main')).toBeNull();
    await page.locator('select[name=series]').selectOption('warnock-bits');
    await page.waitForFunction(() => location.hash.endsWith('series=warnock-bits'));
    const bits = sample.scenes[0]?.runs.filter(
      ({ method, knob }) => method === 'warnock' && knob === 'bits',
    );
    expect((await dots(page, 'added')).length).toBe(bits?.length);
    expect(Number(await strength('main'))).toBeLessThan(0.5);
    expect(await strength('added')).toBeNull();
    const { page: again } = await openChart(browser, new URL(page.url()).hash.slice(1));
    await plot(again).waitFor();
    expect(await again.locator('select[name=series]').inputValue()).toBe('warnock-bits');
    expect(faults).toEqual([]);
  });

  it('shows a point’s picture beside the exact one, with its wrong pixels', async () => {
    const [scene] = sample.scenes;
    if (scene === undefined) throw new Error('no scene');
    // The right picture is white; in the other one, the first pixel is blue.
    const { pixels } = scene;
    const pictures = {
      width: 32,
      colors: ['#ffffff', '#0000ff'],
      shown: [
        [pixels, 0],
        [1, 1, pixels - 1, 0],
      ],
    };
    const runs = scene.runs.map((run) => ({ ...run, picture: run.wrongPixels > 0 ? 1 : 0 }));
    const json = JSON.stringify({ ...sample, scenes: [{ ...scene, pictures, runs }] });
    const { page, faults } = await openChart(browser, 'lang=en&series=printed', json);
    await page.locator('vidno-points summary').click();
    const row = page.locator('vidno-points tr', { hasText: 'as printed' }).last();
    await row.locator('button').click();
    const shots = page.locator('vidno-panel svg');
    expect(await shots.count()).toBe(2);
    expect(await shots.first().locator('.wrong').getAttribute('d')).toBe('M0 0h1v1h-1z');
    expect(await shots.last().locator('.wrong').count()).toBe(0);
    expect(faults).toEqual([]);
  });

  it('is on paper a figure 8 cm wide, without colours and controls', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&view=ordinary/Two walls');
    await plot(page).waitFor();
    await page.emulateMedia({ media: 'print' });
    const paper = page.locator('vidno-plot .printed svg');
    await paper.waitFor();
    const { width = 0 } = (await paper.boundingBox()) ?? {};
    // There are 96 pixels to the inch.
    expect(width).toBeCloseTo((8 / 2.54) * 96, 0);
    expect(overlapping(await textsIn(page, '.printed'))).toEqual([]);
    const colors = await paper
      .locator('[aria-description="main points"] > *')
      .evaluateAll((all) => [...new Set(all.map((dot) => getComputedStyle(dot).stroke))]);
    expect(colors).toEqual(['rgb(0, 0, 0)']);
    expect(await page.locator('vidno-choices').isVisible()).toBe(false);
    expect(faults).toEqual([]);
  });

  it('speaks both languages', async () => {
    const { page, faults } = await openChart(browser, 'lang=en&view=degenerate/Slivers');
    await plot(page).waitFor();
    expect(await page.locator('main').innerText()).not.toMatch(/[а-я]/);
    await page.locator('vidno-languages [lang=ru]').click();
    await page.waitForFunction(() => document.documentElement.lang === 'ru');
    expect(await plot(page).textContent()).toContain('доля неверных пикселей');
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
    expect(await page.locator('select[name=view]').textContent()).toContain('<img');
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
