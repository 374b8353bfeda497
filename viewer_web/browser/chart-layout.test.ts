import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { openChart, sampleText, surfaceText } from './chart.js';
import { widthOf } from './page.js';

describe('the layout of the chart', () => {
  const charts = [
    {
      of: 'scenes',
      json: sampleText,
      views: ['ordinary', 'ordinary/Two walls', 'degenerate/Slivers'],
      errors: ['wrongPixels', 'area', 'wrongDecisions', 'depthUlps'],
    },
    {
      of: 'surfaces',
      json: surfaceText,
      views: ['surfaces', 'surfaces/A peak between two samples'],
      errors: ['wrongColumns', 'height', 'wrongDecisions'],
    },
  ] as const;
  const sizes = charts.flatMap((chart) =>
    [390, 1280, 1920].flatMap((width) =>
      (['en', 'ru'] as const).map((language) => ({ ...chart, width, language })),
    ),
  );

  it.each(sizes)('of $of at $width px in $language is never too wide', async (size) => {
    const { json, views, errors, width, language } = size;
    const viewport = { width, height: width < 500 ? 800 : 1080 };
    const { page, faults } = await openChart(browser, `lang=${language}`, json, { viewport });
    for (const view of views) {
      await page.locator('select').selectOption(view);
      for (const error of errors) {
        await page.locator(`input[value=${error}]`).check();
        expect(await widthOf(page)).toBe(width);
        expect(await outside(page)).toEqual([]);
      }
    }
    expect(faults).toEqual([]);
  });
});

/** Texts that do not lie within the plot; their boxes are a little larger than they are. */
const outside = (page: Page): Promise<readonly string[]> =>
  page.locator('vidno-plot svg').evaluate((svg) => {
    const frame = svg.getBoundingClientRect();
    const slack = 4;
    return [...svg.querySelectorAll('text')]
      .filter((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        const across = left < frame.left - slack || right > frame.right + slack;
        return across || top < frame.top - slack || bottom > frame.bottom + slack;
      })
      .map(({ textContent }) => textContent);
  });

describe('everyone', () => {
  it.each([
    ['light', sampleText],
    ['dark', sampleText],
    ['light', surfaceText],
    ['dark', surfaceText],
    ['light', 'null'],
    ['dark', '{}'],
  ] as const)('can use the chart (WCAG 2.2 AA, %s, %#)', async (colorScheme, json) => {
    const { page } = await openChart(browser, 'lang=ru', json, { colorScheme });
    if (json.includes('"runs"')) await page.locator('vidno-front button').first().focus();
    expect(await violations(page)).toEqual([]);
  });
});
