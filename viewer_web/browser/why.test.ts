import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { edit, handle, looks, openScene, rerun, scene, spotOf } from './live.js';
import { cutOff, open, opened, sampleTrace, widthOf } from './page.js';

const rectangle = (
  id: string,
  width: number,
  height: number,
  depths: readonly number[],
): object => ({
  id,
  color: id === 'A' ? '#e69f00' : '#0072b2',
  vertices: [
    [0, 0, depths[0]],
    [width, 0, depths[1]],
    [width, height, depths[1]],
    [0, height, depths[0]],
  ],
});

/**
 * At the centre of the pixel (2, 1), (5/2, 3/2), A has depth 1/2 and B, at depth x/16, 5/32: the gap is 11/32. Edge 2 of C
 * is there at x = 6 + 3/8, 31/8 from the centre.
 */
const three = scene([
  rectangle('A', 4, 4, [0.5, 0.5]),
  rectangle('B', 8, 4, [0, 0.5]),
  {
    id: 'C',
    color: '#009e73',
    vertices: [
      [6, 0, 0.75],
      [8, 0, 0.75],
      [8, 8, 0.75],
    ],
  },
]);

async function choose(page: Page, x: number, y: number): Promise<void> {
  const spot = await spotOf(page, x + 0.5, y + 0.5);
  await page.mouse.click(spot.x, spot.y);
  await page.locator('vidno-why h3').waitFor();
}

const sentences = 'vidno-why li button';

/** The shapes of the reason in the picture: the edges, the distances and their labels. */
async function drawn(page: Page): Promise<readonly [number, number, readonly string[]]> {
  await settled(page);
  const labels = await page.locator('vidno-picture text.label').allTextContents();
  const fractions = labels.filter((label) => label.includes('/'));
  return [await looks(page, 'side'), await looks(page, 'reach'), fractions];
}

const nothing = [0, 0, []];
const edgeOfC = [2, 2, ['31/8']]; // the lines have casings

const gap = (page: Page): Promise<string | null> =>
  page.locator('vidno-why text.gap').textContent();

describe('the reasons at a pixel', () => {
  it('are drawn in the picture while the pointer is at one, and stay when it is pressed', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await openScene(page, three);
    await choose(page, 2, 1);
    const all = page.locator(sentences);
    expect(await all.nth(1).textContent()).toContain('B is 11/32 farther here');
    expect(await gap(page)).toBe('11/32'); // of the owner and the next
    expect(await drawn(page)).toEqual(nothing);
    await all.nth(2).hover();
    expect(await drawn(page)).toEqual(edgeOfC);
    expect(await page.locator('vidno-why text.gap').count()).toBe(0); // C is not farther
    expect(await page.locator('vidno-why .tick.plane').count()).toBe(1);
    await page.mouse.move(1, 1);
    expect(await drawn(page)).toEqual(nothing);
    await all.nth(2).click();
    await page.mouse.move(1, 1);
    expect(await drawn(page)).toEqual(edgeOfC);
    await page.keyboard.press('ArrowRight'); // a step, since the arrows of the list are up and down
    expect(await drawn(page)).toEqual(edgeOfC);
    await all.nth(2).click();
    await page.mouse.move(1, 1);
    expect(await drawn(page)).toEqual(nothing);
    expect(faults).toEqual([]);
  });

  it('are reached and pressed by keyboard alone', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, three);
    await choose(page, 2, 1);
    await page.locator('vidno-why h3 button').focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    expect(await drawn(page)).toEqual(edgeOfC);
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowUp');
    expect(await drawn(page)).toEqual(nothing); // B is behind
    await page.keyboard.press('Shift+Tab');
    expect(await drawn(page)).toEqual(edgeOfC); // is pressed
    expect(await page.locator(`${sentences}[aria-pressed=true]`).textContent()).toContain('C');
    await page.keyboard.press('Enter'); // on the heading
    expect(await page.locator(sentences).first().isVisible()).toBe(false);
  });

  it('follow a change of the scene', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, three);
    await choose(page, 2, 1);
    await page.locator(sentences).nth(2).click();
    await edit(page);
    // C's vertex (6, 0) moves left by 1/4, and its edge, now on x = 23/4 + 9y/32, passes y = 3/2 at x = 23/4 + 27/64.
    await page.locator(handle(2, 0)).focus();
    await rerun(page, () => page.keyboard.press('ArrowLeft'));
    expect(await drawn(page)).toEqual([2, 2, ['235/64']]); // 395/64 - 5/2
    expect(await page.locator(`${sentences}[aria-pressed=true]`).textContent()).toContain(
      'edge 2 of C passes 235/64 px to the right',
    );
  });

  it('are forgotten with the pixel, and with its panel', async () => {
    const { page } = await open(browser, '#lang=en');
    await openScene(page, three);
    await choose(page, 2, 1);
    await page.locator(sentences).nth(2).click();
    expect(await drawn(page)).toEqual(edgeOfC);
    await choose(page, 6, 6);
    expect(await drawn(page)).toEqual(nothing);
    expect(await page.locator('vidno-why p').textContent()).toBe('no polygon shows');
    await page.locator(sentences).nth(2).click();
    // C's edge is at x = 6 + 13/8 there, and 61/8 - 13/2 = 9/8.
    expect(await drawn(page)).toEqual([2, 2, ['9/8']]);
    await page.locator('vidno-side button.state').click();
    expect(await drawn(page)).toEqual(nothing);
  });

  it('have the step at which the run goes wrong above them', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'one-list.jsonl', sampleTrace('one-list.warnock.signs'));
    // There the edge of A from (3/4, 0) to (0, 2) is at x = 9/16, 1/16 from the centre (1/2, 1/2).
    await choose(page, 0, 0);
    expect(await page.locator('vidno-history .why').textContent()).toMatch(
      /pixel \(0, 0\) shows A.* goes wrong at step \d+/,
    );
    expect(await page.locator(sentences).first().textContent()).toMatch(
      /A shows, .*edge \d of A passes 1\/16 px to the right/,
    );
  });

  it('of many polygons are those that hold the centre, until the others are asked for', async () => {
    const { page } = await open(browser, '#lang=en');
    const beside = Array.from({ length: 60 }, (_, i) => ({
      ...rectangle(`P${i}`, 1, 1, [0, 0]),
      color: '#009e73',
    }));
    await openScene(page, scene([...beside, rectangle('A', 8, 8, [0.5, 0.5])]));
    await choose(page, 4, 4);
    const all = page.locator(sentences);
    const more = page.locator('vidno-why .more');
    expect(await all.count()).toBe(1);
    expect(await more.textContent()).toContain('and 60 others');
    await more.click();
    expect(await all.count()).toBe(41);
    await more.click();
    expect(await all.count()).toBe(61);
    expect(await more.count()).toBe(0);
  });
});

describe('with the reasons at a pixel', () => {
  it('the page is accessible', async () => {
    const { page } = await open(browser, '#lang=ru');
    await openScene(page, three);
    await choose(page, 2, 1);
    await page.locator(sentences).nth(1).click();
    expect(await violations(page)).toEqual([]);
  });

  it.each(['en', 'ru'])('nothing is cut off at any width: %s', async (language) => {
    const { page } = await open(browser, `#lang=${language}`);
    await openScene(page, three);
    await choose(page, 2, 1);
    await page.locator(sentences).nth(2).click();
    for (const width of [320, 390, 768, 1280, 1920]) {
      await page.setViewportSize({ width, height: width < 500 ? 844 : 1080 });
      await settled(page);
      expect(await widthOf(page)).toBe(width);
      const parts = 'vidno-why :is(button, button span, #reasons)';
      expect(await cutOff(page, parts), `at ${width} px`).toEqual([]);
      const ends = await page.locator('vidno-why svg text').evaluateAll((texts) =>
        texts.map((text) => {
          const box = text.closest('svg')?.getBoundingClientRect();
          return (box?.right ?? 0) - text.getBoundingClientRect().right;
        }),
      );
      expect(Math.min(...ends), `at ${width} px`).toBeGreaterThanOrEqual(0);
    }
  });
});
