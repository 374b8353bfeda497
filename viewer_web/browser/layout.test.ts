import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { goTo, launch, open, opened, small } from './page.js';

let browser: Browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
});

describe('the layout', () => {
  const sizes = [390, 768, 1280, 1920].flatMap((width) =>
    (['en', 'ru'] as const).map((language) => ({ width, language })),
  );

  it.each(sizes)(
    'at $width px in $language clips and moves nothing',
    async ({ width, language }) => {
      const viewport = { width, height: width < 500 ? 844 : 1080 };
      const { page, faults } = await open(browser, `#lang=${language}`, { viewport });
      await opened(page, 'small.jsonl', small);
      const places = new Set<string>();
      for (const step of [0, 1, 10, 60, 200, 500, 900]) {
        await goTo(page, step);
        places.add(await frames(page));
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
      }
      expect([...places]).toHaveLength(1);
      expect(faults).toEqual([]);
    },
  );
});

/** Where the parts of the player stand. */
const frames = (page: Page): Promise<string> =>
  page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    await player?.updateComplete;
    const parts = player?.shadowRoot?.querySelectorAll('.picture, .listing, .dock, .sentence');
    return [...(parts ?? [])]
      .map((part) => part.getBoundingClientRect())
      .map(({ x, y, width, height }) => [x, y + scrollY, width, height].map(Math.round).join())
      .join(' ');
  });

describe('everyone', () => {
  it.each(['light', 'dark'] as const)('can use it (WCAG 2.2 AA, %s)', async (colorScheme) => {
    const { page } = await open(browser, '#lang=ru', { colorScheme });
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    expect(await violations(page)).toEqual([]);
  });
});
