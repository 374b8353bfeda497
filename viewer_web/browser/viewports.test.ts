import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { openContents, widthOf } from './page.js';
import { openReader } from './reader.js';

/** A square area has 280 CSS pixels, and a margin of 7 % on each side. */
const least = 280 * 1.14;

interface Found {
  /** The shorter side of each picture. */
  readonly sides: readonly number[];
  /** Controls that reach beyond the left or right edge of the window. */
  readonly out: readonly string[];
  /** Elements whose text is cut off. */
  readonly cut: readonly string[];
}

/** Inspects everything visible, in every shadow tree. */
function look(page: Page): Promise<Found> {
  return page.evaluate(() => {
    const found = { sides: [] as number[], out: [] as string[], cut: [] as string[] };
    const nameOf = (e: Element): string =>
      `${e.localName}.${e.className} ${e.textContent.trim().slice(0, 30)}`;
    const see = (e: HTMLElement): void => {
      const { left, right, width, height } = e.getBoundingClientRect();
      if (width === 0 || !e.checkVisibility()) return;
      if (e.localName === 'vidno-picture') found.sides.push(Math.min(width, height));
      if (!e.matches('button, select, input, a, h2, .sentence')) return;
      if (left < -0.5 || right > innerWidth + 0.5) found.out.push(nameOf(e));
      const isCut = e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0;
      if (isCut && !e.matches('input, select')) found.cut.push(nameOf(e));
    };
    const walk = (root: ParentNode): void => {
      for (const e of root.querySelectorAll<HTMLElement>('*')) {
        see(e);
        if (e.shadowRoot) walk(e.shadowRoot);
      }
    };
    walk(document);
    return found;
  });
}

async function isSound(page: Page, width: number, when: string): Promise<void> {
  const { sides, out, cut } = await look(page);
  expect(sides, when).toHaveLength(1);
  // On a low screen the picture is as high as the screen without the header and its own footer.
  const { height } = page.viewportSize() ?? { height: 0 };
  const isLow = height < 400 && width > 560;
  expect(Math.min(...sides), when).toBeGreaterThanOrEqual(isLow ? 0.75 * height : least);
  expect({ out, cut }, when).toEqual({ out: [], cut: [] });
  expect(await widthOf(page), when).toBe(width);
}

/** The visible part of an element inside its scrolling box. */
const seen = (page: Page, part: string, box: string): Promise<number> =>
  page.locator(part).evaluate((e, selector) => {
    const inner = e.getBoundingClientRect();
    let outer: Element | null = e.closest(selector);
    for (let root = e.getRootNode(); outer === null && root instanceof ShadowRoot;) {
      outer = root.host.closest(selector);
      root = root.host.getRootNode();
    }
    const { top = 0, bottom = 0 } = outer?.getBoundingClientRect() ?? {};
    return Math.min(inner.bottom, bottom) - Math.max(inner.top, top);
  }, box);

const height = async (page: Page, part: string): Promise<number> =>
  (await page.locator(part).boundingBox())?.height ?? 0;

/** Further checks at some sizes, with the text of the lesson beside the run. */
const besides: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  '1920 x 1080': async (page) => {
    // In a lecture hall nobody scrolls to the current line of C++, either.
    await page.keyboard.press('w');
    await page.locator('.dock input[type=number]').fill('60');
    await page.locator('.dock input[type=number]').press('Enter');
    await page.locator('.dock input[type=number]').blur();
    await page.keyboard.press('c');
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    const line = await height(page, 'vidno-cpp .now >> nth=0');
    await expect
      .poll(() => seen(page, 'vidno-cpp .now >> nth=0', '.files'))
      .toBeGreaterThan(line - 1);
    await page.keyboard.press('Escape');
    await page.locator('.corner').waitFor({ state: 'detached' });
    await page.keyboard.press('c');
    await page.keyboard.press('w');
  },
  '1440 x 900': async (page) => {
    // Before the first step the listing is scrolled to its top, from any earlier position.
    await page.keyboard.press('End');
    await page.keyboard.press('Home');
    const top = page.locator('vidno-listing .procedures');
    await expect.poll(() => top.evaluate((e) => e.scrollTop)).toBe(0);
    await page.keyboard.press('v');
    const bar = 40;
    expect(await height(page, 'vidno-solid-stage')).toBeGreaterThan(180 + bar);
    await page.keyboard.press('v');
    // The strip's tooltip does not cover the sentence.
    await page.keyboard.press('w');
    await page.locator('vidno-slider .strip').hover();
    const tip = await page.locator('.tip').boundingBox();
    const sentence = await page.locator('.sentence').boundingBox();
    expect(tip?.y).toBeGreaterThanOrEqual((sentence?.y ?? NaN) + (sentence?.height ?? NaN));
    await page.keyboard.press('w');
  },
  '1024 x 768': contents,
  '390 x 844': async (page) => {
    await contents(page);
    // A question leaves its picture in sight.
    await page.keyboard.press('q');
    await page.locator('vidno-question h3').waitFor();
    const picture = await page.locator('vidno-picture').boundingBox();
    const asked = await page.locator('vidno-question h3').boundingBox();
    expect(picture?.y).toBeGreaterThanOrEqual(0);
    expect(asked?.y).toBeGreaterThan((picture?.y ?? NaN) + (picture?.height ?? NaN));
    expect(asked?.y).toBeLessThan(844);
    await page.keyboard.press('Escape');
  },
};

/** The lessons have more than half as much room as the text, and nothing beside them takes more room than it needs. */
async function contents(page: Page): Promise<void> {
  const text = await height(page, 'vidno-reader .box');
  await openContents(page);
  const all = await height(page, 'vidno-lesson-list');
  expect(await seen(page, 'vidno-lesson-list', 'nav')).toBeGreaterThan(
    Math.min(0.5 * text, all - 1),
  );
  expect(await height(page, 'nav .again')).toBeLessThan(48);
  await page.locator('vidno-page-header button.contents').click();
}

describe('at every size the picture is large, nothing sticks out and nothing is cut', () => {
  it.each([
    [1920, 1080, 'en'],
    [1440, 900, 'en'],
    [1280, 720, 'en'], // 1280 x 720, and half and a quarter of it: enlarged to 200 % and 400 %
    [640, 360, 'en'],
    [320, 180, 'ru'],
    [1024, 768, 'en'],
    [390, 844, 'en'],
    [844, 390, 'en'],
    [320, 640, 'ru'],
  ])('%i x %i, %s', async (width, height, language) => {
    const viewport = { width, height };
    const address = `#lang=${language}&lesson=first`;
    const { page, faults } = await openReader(browser, address, { viewport });
    await isSound(page, width, 'beside the text');
    await besides[`${width} x ${height}`]?.(page);
    await page
      .locator('vidno-page-header')
      .getByRole('button', { name: /^(Text|Текст)/ })
      .click();
    await page.locator('vidno-reader').waitFor({ state: 'hidden' });
    await isSound(page, width, 'alone');
    // A browser without a graphics card reports that.
    expect(faults.filter((fault) => !fault.includes('WebGL'))).toEqual([]);
  });
});

describe("in the system's own colours", () => {
  it('shows what is current, pressed or changed, and the slider', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&view=workbench', {
      forcedColors: 'active',
    });
    const field = page.locator('.dock input[type=number]');
    // Goes to a step that changes a value.
    for (let step = 1; (await page.locator('vidno-warnock dd.changed').count()) === 0; step++) {
      await field.fill(String(step));
      await field.press('Enter');
    }
    await page.locator('vidno-listing .now').waitFor();
    const looks = await page.evaluate(() => {
      const all = (root: ParentNode, selector: string): Element[] => [
        ...root.querySelectorAll(selector),
        ...[...root.querySelectorAll('*')].flatMap((e) =>
          e.shadowRoot ? all(e.shadowRoot, selector) : [],
        ),
      ];
      const background = (selector: string): string[] => [
        ...new Set(all(document, selector).map((e) => getComputedStyle(e).backgroundColor)),
      ];
      const probe = document.body.appendChild(document.createElement('i'));
      probe.style.cssText = 'forced-color-adjust: none; background: Highlight';
      const slider = all(document, '.slider')[0] ?? probe;
      return {
        highlight: getComputedStyle(probe).backgroundColor,
        line: background('vidno-listing .now, .procedures .now'),
        pressed: background("button[aria-pressed='true']"),
        others: background(".procedures li:not(.now), button[aria-pressed='false']"),
        changed: all(document, '.changed').map((e) => getComputedStyle(e).outlineStyle),
        slider: getComputedStyle(slider).forcedColorAdjust,
      };
    });
    expect(looks.line).toEqual([looks.highlight]);
    expect(looks.pressed).toEqual([looks.highlight]);
    expect(looks.others).not.toContain(looks.highlight);
    expect(new Set(looks.changed)).toEqual(new Set(['solid']));
    expect(looks.slider).toBe('none');
  });

  it('shows that the current line has a variant', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&view=workbench', {
      forcedColors: 'active',
    });
    const mark = page.locator('vidno-listing .now .mark');
    while ((await mark.count()) === 0) await page.keyboard.press('ArrowRight');
    const color = (element: Element): string => getComputedStyle(element).color;
    expect(await mark.evaluate(color)).toBe(
      await page.locator('vidno-listing .now').evaluate(color),
    );
  });
});
