import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { browser, settled } from './browser.js';
import { open } from './page.js';

const sizes = [
  [1440, 900],
  [390, 844],
  [844, 390],
  [320, 640],
  [640, 360], // 1280 x 720, enlarged to 200 %
] as const;

/** Which of these parts are not wholly on the screen, are covered, or do not show all of their text. */
const hidden = (page: Page, parts: readonly string[]): Promise<readonly string[]> =>
  Promise.all(
    parts.map(async (part) => {
      const isShown = await page
        .locator(part)
        .first()
        .evaluate((each) => {
          const { left, top, right, bottom, width } = each.getBoundingClientRect();
          const isIn = left >= 0 && top >= 0 && right <= innerWidth + 0.5 && bottom <= innerHeight;
          const root = each.getRootNode() as ShadowRoot;
          const onTop = root.elementFromPoint((left + right) / 2, (top + bottom) / 2);
          const isSeen = each.contains(onTop);
          return width > 0 && isIn && isSeen && each.scrollHeight <= each.clientHeight + 1;
        });
      return isShown ? [] : [part];
    }),
  ).then((all) => all.flat());

/** The controls that reach beyond a side of the window. */
const cutOff = (page: Page): Promise<readonly string[]> =>
  page.locator(':is(button, select, input, a, .sentence):visible').evaluateAll((all) =>
    all
      .filter((each) => each.checkVisibility({ visibilityProperty: true }))
      .filter((each) => {
        const { left, right } = each.getBoundingClientRect();
        return left < -0.5 || right > innerWidth + 0.5;
      })
      .map((each) => each.textContent.trim()),
  );

/** Taps a pixel that C covers, and B below it. */
async function tap(page: Page): Promise<void> {
  const box = await page.locator('vidno-picture').boundingBox();
  if (box === null) throw new Error('no picture');
  await page.mouse.click(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
}

const controls = ['vidno-picture', '.sentence', 'vidno-transport .play'];

it.each(['en', 'ru'])(
  'the first screen shows what to do, at each size, in %s',
  async (language) => {
    const { page, faults } = await open(browser, `#lang=${language}`);
    await page.locator('.sentence .welcome').waitFor();
    for (const [width, height] of sizes) {
      const size = `${width} x ${height}`;
      await page.setViewportSize({ width, height });
      await settled(page);
      expect(await hidden(page, controls), size).toEqual([]);
      expect(await cutOff(page), size).toEqual([]);
      expect(await page.locator('vidno-transport .words:visible').count(), size).toBe(1);
      if (width > 1000) {
        const more = ['.greeting', 'vidno-reader article > p', 'vidno-page-header button.own'];
        expect(await hidden(page, more), size).toEqual([]);
        expect(await page.locator('vidno-side').count()).toBe(0); // its stack is empty
        continue;
      }
      // The text gives way to what a tap asks for, and comes back.
      await tap(page);
      await page.locator('vidno-history .why').waitFor();
      await settled(page);
      expect(await hidden(page, ['vidno-history .why']), size).toEqual([]);
      await page.locator('.fronts button').first().click();
      await page.locator('vidno-history').waitFor({ state: 'hidden' });
      expect(await page.locator('vidno-reader').isVisible(), size).toBe(true);
      // The tools of the editor are in sight, too.
      await page.keyboard.press('e');
      await page.locator('vidno-scene-panel .draw').waitFor();
      await settled(page);
      expect(await hidden(page, ['vidno-scene-panel .draw']), size).toEqual([]);
      await page.keyboard.press('e');
      await page.locator('vidno-history .forget').click();
      await page.locator('.fronts button').first().click();
      await page.evaluate(() => {
        scrollTo(0, 0);
      });
    }
    expect(faults).toEqual([]);
  },
);

it('a lesson folds its goals to a line, which opens by keyboard', async () => {
  const { page } = await open(browser, '#lang=en');
  const goals = page.locator('vidno-reader .frame');
  await goals.waitFor({ state: 'attached' });
  expect(await goals.isVisible()).toBe(false);
  await page.locator('vidno-reader .about summary').press('Enter');
  await goals.waitFor();
});
