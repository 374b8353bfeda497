import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { looks, openScene, run } from './live.js';
import { goTo, open } from './page.js';

/** The corners of the square lie on the centres of the pixels at the corners of a 2 x 2 area. */
const square = {
  format: 'vidno-scene/1',
  name: 'On centres',
  window: { x: 0, y: 0, width: 2, height: 2 },
  background: '#ffffff',
  polygons: [
    {
      id: 'A',
      color: '#1f77b4',
      vertices: [
        [0.5, 0.5, 0.25],
        [1.5, 0.5, 0.25],
        [1.5, 1.5, 0.25],
        [0.5, 1.5, 0.25],
      ],
    },
  ],
};

describe('the decisions worth looking at', () => {
  it('are listed, sorted, marked on the strip and in the picture, and linked to their steps', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, JSON.stringify(square));
    await page.locator('vidno-side button.exact').click();
    const list = page.locator('vidno-findings');
    await list.getByText('exactly zero').first().waitFor();
    const first = list.locator('tbody button').first();
    const step = Number(await first.textContent());
    await first.click();
    await expect.poll(() => page.locator('vidno-slider input').inputValue()).toBe(String(step));
    await list.getByRole('button', { name: 'Ulps from zero' }).click();
    expect(await list.locator('th[aria-sort=ascending]').textContent()).toContain('Ulps');
    expect(await page.locator('vidno-slider .found.zero').count()).toBeGreaterThan(0);
    expect(await violations(page)).toEqual([]);
  });

  it('can be recalculated line by line', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, JSON.stringify(square));
    await page.locator('vidno-side button.exact').click();
    await page.locator('vidno-findings').waitFor();
    const { lines } = await run(page);
    const orient = lines.findIndex((line) => line.includes('"e":"orient"')) + 1;
    await goTo(page, orient);
    const byHand = page.locator('vidno-exactness .by-hand .lines li');
    await byHand.first().waitFor();
    expect(await byHand.first().textContent()).toContain('f = (aₓ − oₓ)');
  });
});

describe('the margin of a vertex', () => {
  it('is shaded while the vertex is chosen, with the changes beyond its sides', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, JSON.stringify(square));
    const { lines } = await run(page);
    await goTo(page, lines.findIndex((line) => line.includes('"e":"orient"')) + 1);
    await page.locator('vidno-side button.scene').click();
    await page.locator('vidno-handles [data-spot="0,3"]').focus();
    await expect.poll(() => looks(page, 'margin')).toBeGreaterThan(0);
  });
});
