import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { looks } from './live.js';
import { cutOff, goTo, open, opened, sampleTrace, shown, whole, widthOf } from './page.js';
import { asked } from './predict.js';

const wedge = sampleTrace('wedge.weiler-atherton.signs');

async function openWedge(
  hash = '#lang=en',
  options: Parameters<typeof open>[2] = {},
): Promise<{ page: Page; faults: readonly string[] }> {
  const { page, faults } = await open(browser, hash, options);
  await opened(page, 'wedge.jsonl', wedge);
  return { page, faults };
}

/** The number of the first step, counted from `from`, whose line in the file matches. */
const stepOf = (pattern: RegExp, from = 1): number =>
  wedge.split('\n').findIndex((line, i) => i >= from && pattern.test(line));

/** A clip that leaves something inside and something outside. */
const clip = stepOf(/"clipped","at":"WA5","polygon":"C","clip":"B"/);

describe('a run of Weiler and Atherton’s algorithm', () => {
  it('is replayed in the terms of the algorithm, with the listing', async () => {
    const { page, faults } = await openWedge();
    await goTo(page, stepOf(/"behind"/));
    // A has depth 1/4 everywhere, C has (x - 7) / 8, which is 1/2 at x = 11.
    expect(await shown(page)).toMatchObject({
      line: 'RB3',
      sentence: expect.stringContaining(
        'A has depth 1/4 and C has 1/2: less, so A is behind',
      ) as string,
    });
    await page.getByRole('button', { name: 'C++' }).click();
    expect(await page.locator('vidno-cpp').getByText('run.trace.behind(RB3').count()).toBe(1);
    await page.getByRole('button', { name: 'C++' }).click();
    await page.keyboard.press('End');
    expect((await shown(page)).line).toBe('WA10');
    expect(faults).toEqual([]);
  });

  it('shows the clip polygon, the parts inside and outside, and where the outline crosses', async () => {
    const { page } = await openWedge();
    await goTo(page, clip);
    expect(await looks(page, 'clip-region')).toBe(2); // with its casing
    expect(await looks(page, 'inside-part')).toBe(2); // hatch and outline
    expect(await looks(page, 'outside-part')).toBe(2);
    expect(await looks(page, 'enters')).toBe(1);
    expect(await looks(page, 'shown')).toBe(1);
    await page.getByRole('checkbox', { name: 'inside, outside' }).click();
    expect(await looks(page, 'inside-part')).toBe(0);
    await page.getByRole('checkbox', { name: 'visible' }).click();
    expect(await looks(page, 'shown')).toBe(0);
  });

  it('lists the parts inside and outside, and the areas of the visible regions', async () => {
    const { page } = await openWedge();
    await goTo(page, clip);
    const panel = page.locator('vidno-regions');
    expect(await panel.getByRole('region', { name: 'Inside' }).locator('tr').count()).toBe(1);
    expect(await panel.getByRole('region', { name: 'Outside' }).locator('tr').count()).toBe(2);
    // The visible part of C has x from 9 to 15 and y from 5 to 11.
    expect(await panel.getByRole('region', { name: 'Visible regions' }).innerText()).toContain(
      'area 36',
    );
  });

  it('asks what is behind', async () => {
    const { page } = await openWedge();
    await goTo(page, stepOf(/"call","at":"WA7"/) - 1);
    await page.locator('.dock input[type=number]').blur();
    await page.keyboard.press('q');
    await asked(page, stepOf(/"call","at":"WA7"/));
    expect(await page.locator('vidno-question h3').innerText()).toContain(
      'RemoveBehind: the parts inside C',
    );
  });

  it.each([
    ['en', { width: 1280, height: 800 }],
    ['ru', { width: 390, height: 844 }],
  ] as const)('is accessible: %s', async (language, viewport) => {
    const { page } = await openWedge(`#lang=${language}`, { viewport });
    await goTo(page, clip);
    expect(await violations(page)).toEqual([]);
  });

  it.each(['en', 'ru'])(
    'lists everything in full, in a window of any width: %s',
    async (language) => {
      const trace = '14-weiler-atherton.cycle.weiler-atherton.exact.corrected.polygons';
      const { page } = await open(browser, `#lang=${language}&trace=${trace}&view=workbench`);
      const button = page.locator(`button[data-trace="${trace}"][aria-pressed="true"]`);
      await button.waitFor({ state: 'attached' });
      await whole(page);
      const { length } = await shown(page);
      for (const width of [360, 390, 768, 961, 1024, 1280, 1500, 1920]) {
        await page.setViewportSize({ width, height: 1080 });
        for (const part of [0.3, 0.5, 1]) {
          await goTo(page, Math.floor(part * length));
          const cut = await cutOff(page, 'vidno-regions :is(dt, .list)');
          expect([width, cut]).toEqual([width, []]);
        }
        expect(await widthOf(page)).toBe(width);
      }
    },
  );
});
