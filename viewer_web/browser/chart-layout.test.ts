import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { openChart, sampleText, surfaceText } from './chart.js';

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
  const each = charts.flatMap((chart) =>
    (['en', 'ru'] as const).map((language) => ({ ...chart, language })),
  );

  it.each(each)(
    'of $of in $language is never too wide, and no two names overlap',
    async (chart) => {
      const { json, views, errors, language } = chart;
      const { page, faults } = await openChart(browser, `lang=${language}`, json);
      for (const width of [390, 1024, 1440]) {
        await page.setViewportSize({ width, height: width < 500 ? 800 : 1080 });
        await settled(page);
        for (const view of views) {
          await page.locator('select[name=view]').selectOption(view);
          const found = await eachOf(page, errors);
          const right = errors.map((error) => ({ error, across: width, outside: [], covered: [] }));
          expect(found, `${view} at ${width} px`).toEqual(right);
        }
      }
      expect(faults).toEqual([]);
    },
  );
});

interface Found {
  readonly error: string;
  /** The width of the page. */
  readonly across: number;
  /** Texts outside the plot. Their boxes are a little larger than the texts. */
  readonly outside: readonly (string | null)[];
  /** Pairs of texts that cover each other. */
  readonly covered: readonly string[];
}

/** Inspects the plot with each of the errors inside the page, because a round trip takes longer than drawing. */
const eachOf = (page: Page, errors: readonly string[]): Promise<readonly Found[]> =>
  page.locator('vidno-chart').evaluate(async (chart, values) => {
    const slack = 4;
    // The box of a text is a little higher than its letters.
    const lead = 1.5;
    const part = (selector: string): Element => {
      const search = (root: ParentNode): Element | null => {
        const inside = [...root.querySelectorAll('*')].map(({ shadowRoot }) => shadowRoot);
        const own = root.querySelector(selector);
        return (
          own ?? inside.reduce<Element | null>((got, sub) => got ?? (sub && search(sub)), null)
        );
      };
      const found = chart.shadowRoot && search(chart.shadowRoot);
      if (!found) throw new Error(`no ${selector}`);
      return found;
    };
    const found: Found[] = [];
    for (const error of values) {
      const input = part(`input[value=${error}]`) as HTMLInputElement;
      input.click();
      if (!input.checked) throw new Error(`${error} cannot be chosen`);
      await new Promise(requestAnimationFrame);
      await new Promise(requestAnimationFrame);
      const svg = part('vidno-plot').shadowRoot?.querySelector('.canvas svg');
      if (!svg) throw new Error('no plot');
      const frame = svg.getBoundingClientRect();
      const outside = [...svg.querySelectorAll('text')].filter((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        const across = left < frame.left - slack || right > frame.right + slack;
        return across || top < frame.top - slack || bottom > frame.bottom + slack;
      });
      const across = document.documentElement.scrollWidth;
      const boxes = [...svg.querySelectorAll('text')]
        .map((text) => [text.textContent, text.getBoundingClientRect()] as const)
        .filter(([, { width }]) => width > 0);
      const covered = boxes.flatMap(([a, one], i) =>
        boxes
          .slice(i + 1)
          .filter(([, other]) => {
            const wide = Math.min(one.right, other.right) - Math.max(one.left, other.left);
            const high = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
            return wide > lead && high > lead;
          })
          .map(([b]) => `${a} | ${b}`),
      );
      found.push({
        error,
        across,
        outside: outside.map(({ textContent }) => textContent),
        covered,
      });
    }
    return found;
  }, errors);

describe('accessibility', () => {
  const charts = [sampleText, surfaceText, 'null', '{}'];
  it.each(charts)('can use the chart (WCAG 2.2 AA, %#)', async (json) => {
    const { page } = await openChart(browser, 'lang=ru', json);
    if (json.includes('"runs"')) await page.locator('vidno-points summary').click();
    expect(await violations(page)).toEqual([]);
  });
});
