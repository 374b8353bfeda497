import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { compared, comparing, stepsOf } from './compare.js';
import { goTo, open, placesOf, widthOf } from './page.js';

const lesson = 'trace=09-usual-mistakes.warnock.double.corrected.signs';

describe('a comparison', () => {
  it.each(['en', 'ru'])('clips and moves nothing at any width, in %s', async (language) => {
    const hash = `#lang=${language}&${lesson}&with=warnock.printed.double.signs`;
    const { page, faults } = await open(browser, hash);
    await compared(page);
    for (const width of [390, 768, 1024, 1280, 1920]) {
      await page.setViewportSize({ width, height: width < 500 ? 844 : 1080 });
      const places = new Set<string>();
      for (const step of [0, 18, 500, 5337]) {
        await goTo(page, step);
        await stepsOf(page);
        places.add(
          await placesOf(page, 'vidno-compared-run :is(.picture, .listing, .sentence), .dock'),
        );
        expect(await widthOf(page)).toBe(width);
      }
      expect([...places], `at ${width} px`).toHaveLength(1);
    }
    expect(faults).toEqual([]);
  });

  it('has pictures, listings and sentences on one screen where the page scrolls', async () => {
    const viewport = { width: 1024, height: 768 };
    const hash = `#lang=ru&${lesson}&with=warnock.printed.double.signs`;
    const { page } = await open(browser, hash, { viewport });
    await compared(page);
    const dock = await page.locator('vidno-comparison .dock').boundingBox();
    expect((dock?.y ?? NaN) + (dock?.height ?? NaN)).toBeLessThanOrEqual(viewport.height);
    for (const part of ['.picture', '.listing', '.sentence']) {
      const both = await page.locator(`vidno-compared-run ${part}`).all();
      expect(both).toHaveLength(2);
      for (const each of both) {
        const box = await each.boundingBox();
        expect((box?.y ?? NaN) + (box?.height ?? NaN)).toBeLessThanOrEqual(dock?.y ?? NaN);
      }
    }
  });

  it('can be used by all (WCAG 2.2 AA)', async () => {
    const { page } = await comparing(browser, `${lesson}&with=zbuffer.corrected.double.signs`);
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('d');
    await page.keyboard.press('d');
    await page.locator('vidno-rival-choice dialog[open]').waitFor();
    expect(await violations(page)).toEqual([]);
  });

  it('is printed on one sheet, with both pictures and sentences', async () => {
    const { page } = await comparing(browser, `${lesson}&with=zbuffer.corrected.double.signs`);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    expect(pdf.match(/\/Type\s*\/Page\b/g)).toHaveLength(1);
    await page.emulateMedia({ media: 'print' });
    for (const shown of ['vidno-picture', 'vidno-compared-run .sentence', '.differ']) {
      for (const each of await page.locator(shown).all()) expect(await each.isVisible()).toBe(true);
    }
    for (const hidden of ['header', 'nav', 'vidno-transport', '.switches']) {
      for (const each of await page.locator(hidden).all())
        expect(await each.isVisible()).toBe(false);
    }
  });

  it('is presented with two pictures and the sentences', async () => {
    const { page } = await comparing(browser, `${lesson}&with=zbuffer.corrected.double.signs`);
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    await page.keyboard.press('PageDown');
    expect((await stepsOf(page))[0]).toBe(1);
    for (const hidden of ['vidno-comparison-facts', 'vidno-comparison vidno-transport']) {
      expect(await page.locator(hidden).isVisible()).toBe(false);
    }
    const box = await page.locator('vidno-comparison').boundingBox();
    expect(box).toEqual({ x: 0, y: 0, width: 1280, height: 800 });
    await page.keyboard.press('Escape');
    await page.locator('.corner').waitFor({ state: 'detached' });
  });
});
