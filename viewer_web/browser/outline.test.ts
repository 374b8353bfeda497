import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { title } from './live.js';
import { goTo, open, opened, repeated, sampleTrace, shown, small } from './page.js';
import { press } from './predict.js';

const zbuffer = sampleTrace('small.zbuffer.signs');

const stepOf = async (page: Page): Promise<number> => (await shown(page)).step;
const panel = (page: Page): Promise<string | null> =>
  page.locator('vidno-side button[aria-pressed=true]').getAttribute('class');

/** All rows of the outline, each with its level and text. */
const rows = (page: Page): Promise<readonly string[]> =>
  page
    .locator('vidno-outline [role=treeitem]')
    .evaluateAll((all) =>
      all
        .sort(
          (a, b) =>
            Number((a as HTMLElement).dataset['node']) - Number((b as HTMLElement).dataset['node']),
        )
        .map((row) => `${row.ariaLevel ?? ''} ${row.querySelector('.said')?.textContent ?? ''}`),
    );
const current = (page: Page) => page.locator('vidno-outline [aria-current=step]');
const said = (page: Page): Promise<string | null> => current(page).locator('.said').textContent();
const status = (page: Page): Promise<string | null> =>
  page.locator('vidno-outline [role=search] [role=status]').textContent();

/** A page with a run whose outline is open and completely read. */
async function outlined(text: string, hash = '#lang=en', height = 1080): Promise<Page> {
  const { page, faults } = await open(browser, hash, { viewport: { width: 1280, height } });
  await opened(page, 'run.jsonl', text);
  await page.locator(title).click();
  await press(page, 't');
  await page.locator('vidno-outline .tree[aria-busy=false]').waitFor({ timeout: 60_000 });
  expect(faults).toEqual([]);
  return page;
}

describe('the outline', () => {
  it('is opened by its key, which says so, and by its tab', async () => {
    const page = await outlined(zbuffer);
    expect(await panel(page)).toBe('outline');
    await expect.poll(() => page.locator('.news').textContent()).toContain('Panel: Outline');
    await press(page, 't');
    expect(await panel(page)).toBe('state');
    await page.locator('vidno-side button.outline').click();
    expect(await rows(page)).toEqual(['1 polygon A: rows −1 to 2', '1 polygon B: rows −1 to 2']);
  });

  it('marks the node of the step, unfolds its ancestors, and folds them again afterwards', async () => {
    const page = await outlined(zbuffer);
    expect(await current(page).count()).toBe(0); // nothing is current at the start
    const steps = zbuffer.split('\n').map((line, i) => ({ line, i }));
    const row = steps.find(({ line }) => line.includes('"e":"scanline"'))?.i ?? 0;
    await goTo(page, row);
    await expect.poll(() => said(page)).toMatch(/^row −1: /);
    const second = steps.filter(({ line }) => line.includes('"e":"polygon"'))[1]?.i ?? 0;
    await goTo(page, second);
    await expect.poll(() => said(page)).toMatch(/^polygon B/);
    expect(await rows(page)).toHaveLength(2);
  });

  it('goes to the step of a clicked row, and nothing moves under the mouse', async () => {
    const page = await outlined(zbuffer);
    await page.locator('vidno-outline .fold').first().click();
    expect(await stepOf(page)).toBe(0);
    const row = page.locator('vidno-outline [role=treeitem]', { hasText: 'row 1' }).first();
    const before = await row.boundingBox();
    await row.click();
    const step = zbuffer.split('\n').findIndex((line) => line.includes('"row":1'));
    expect(await stepOf(page)).toBe(step);
    expect(await row.boundingBox()).toEqual(before);
    expect(await row.getAttribute('aria-current')).toBe('step');
  });

  it('is navigated by keyboard, while other keys do what they do elsewhere', async () => {
    const page = await outlined(zbuffer);
    await press(page, 'Shift+T');
    const focused = async (): Promise<string | null> => {
      const id = await page
        .locator('vidno-outline [role=tree]')
        .getAttribute('aria-activedescendant');
      return page.locator(`vidno-outline #${id ?? 'none'} .said`).textContent();
    };
    await press(page, 'ArrowDown', 'ArrowUp');
    expect(await focused()).toMatch(/^polygon A/);
    await press(page, 'ArrowRight', 'ArrowRight');
    expect(await focused()).toMatch(/^row −1/);
    await press(page, 'End');
    expect(await focused()).toMatch(/^polygon B/);
    expect(await stepOf(page)).toBe(0);
    await press(page, 'Enter');
    const step = await stepOf(page);
    expect(step).toBeGreaterThan(0);
    await press(page, 'Home', 'ArrowLeft');
    expect(await rows(page)).toHaveLength(2);
    await press(page, ' ');
    await page.getByRole('button', { name: 'Pause' }).click();
    await press(page, 'x');
    await expect.poll(() => panel(page)).toBe('exact');
  });

  it('renders only the visible rows of a long run, and keeps the current row among them', async () => {
    const page = await outlined(repeated(small, /"at":"W3"/, 60_000));
    expect(await page.locator('vidno-outline [role=treeitem]').count()).toBeLessThan(100);
    const isSeen = (): Promise<boolean> =>
      page.locator('vidno-outline').evaluate((outline) => {
        const tree = outline.shadowRoot?.querySelector('.tree')?.getBoundingClientRect();
        const row = outline.shadowRoot?.querySelector('.now')?.getBoundingClientRect();
        return (
          tree !== undefined &&
          row !== undefined &&
          row.top >= tree.top &&
          row.bottom <= tree.bottom
        );
      });
    for (const step of [40_000, 20_000, 59_000]) {
      await goTo(page, step);
      await expect.poll(isSeen).toBe(true);
    }
    const set = await current(page).evaluate((row) =>
      [row.ariaPosInSet, row.ariaSetSize].map(Number),
    );
    expect(set[0]).toBeGreaterThan(0);
    expect(set[0]).toBeLessThanOrEqual(set[1] ?? 0);
    await page.locator(title).click();
    for (let i = 0; i < 30; i++) {
      await press(page, 'ArrowLeft');
      await expect.poll(isSeen).toBe(true);
    }
  });

  it('is not shown while the run stops for questions', async () => {
    const page = await outlined(small);
    await press(page, 'q');
    await page.locator('vidno-predict .force').check();
    await press(page, 't');
    await page.locator('vidno-outline', { hasText: 'it would show the answer' }).waitFor();
    expect(await page.locator('vidno-outline [role=tree]').count()).toBe(0);
  });
});

describe('the search of the outline', () => {
  const hits = (page: Page): Promise<number> =>
    page
      .locator('vidno-hits')
      .evaluate((strip) => ('hits' in strip ? (strip.hits as number[]).length : 0));

  it('finds by plain words, goes from hit to hit, and marks them on the strip', async () => {
    const page = await outlined(small);
    const splits = small.split('\n').filter((line) => line.includes('"case":"split"')).length;
    await press(page, 'Shift+T', '/');
    await page.keyboard.type('split');
    await expect.poll(() => status(page)).toBe(`${splits} hits`);
    expect(await hits(page)).toBe(splits);
    expect(await page.locator('vidno-outline .chip').allTextContents()).toEqual([
      expect.stringContaining('case split'),
    ]);
    await press(page, 'Enter', 'Enter');
    await expect.poll(() => status(page)).toBe(`2 of ${splits} hits`);
    await expect.poll(() => said(page)).toMatch(/: split$/);
    await press(page, 'Shift+Enter');
    await expect.poll(() => status(page)).toBe(`1 of ${splits} hits`);
    await page.locator('vidno-outline .next').click();
    await expect.poll(() => status(page)).toBe(`2 of ${splits} hits`);
  });

  it('takes terms with facet names, explains them, and removes them', async () => {
    const page = await outlined(small, '#lang=ru');
    const field = page.getByRole('combobox', { name: 'Поиск в структуре' });
    await field.fill('polygon:B случай:делится nobody');
    const chips = page.locator('vidno-outline .chip');
    await expect.poll(() => chips.count()).toBe(3);
    expect((await chips.allTextContents()).map((chip) => chip.replace('✕', '').trim())).toEqual([
      'многоугольник B',
      'случай делится',
      'ничего с названием «nobody» здесь нет',
    ]);
    await expect.poll(() => status(page)).toBe('совпадений нет');
    await chips.nth(2).click();
    await expect.poll(() => status(page)).toMatch(/^\d+ совпадени/);
    expect(await field.inputValue()).toBe('polygon:B случай:делится');
    await press(page, 'Escape');
    expect(await field.inputValue()).toBe('');
    await expect.poll(() => hits(page)).toBe(0);
  });

  it('is kept while another panel is shown', async () => {
    const page = await outlined(small);
    await page.locator('vidno-outline input').fill('split');
    await expect.poll(() => hits(page)).toBeGreaterThan(0);
    await page.locator(title).click();
    await press(page, 'x', 't');
    expect(await page.locator('vidno-outline input').inputValue()).toBe('split');
    await expect.poll(() => status(page)).toMatch(/hits$/);
  });
});

describe.each(['en', 'ru'] as const)('the outline in %s', (language) => {
  it('is accessible', async () => {
    const viewport = { width: 1440, height: 1080 };
    const { page } = await open(browser, `#lang=${language}`, { viewport });
    await opened(page, 'small.jsonl', small);
    await page.locator(title).click();
    await press(page, 't');
    await page.locator('vidno-outline input').fill('B split nobody');
    await goTo(page, 60);
    await page.locator('vidno-outline .now').waitFor();
    expect(await violations(page)).toEqual([]);
  });
});
