import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { readingLine } from '../src/reader/reading-place.js';
import type { Area } from '../src/trace/header.js';
import { browser, settled } from './browser.js';
import { spotOf } from './live.js';
import { openContents, shown, whole } from './page.js';
import { openReader, pin, readTo, scrolled, standing } from './reader.js';

/** The distance of a pin from the top of the text's box. */
const below = (page: Page, place: string): Promise<number> =>
  pin(page, place).evaluate((mark) => {
    const box = mark.closest('.box')?.getBoundingClientRect() ?? new DOMRect();
    return mark.getBoundingClientRect().top - box.top;
  });

const title = (page: Page): Promise<string | null> => page.locator('article h2').textContent();

describe('the table of contents', () => {
  it('lists the headings of the lesson, goes to them, and marks the current one', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    await openContents(page);
    const headings = page.locator('vidno-lesson-list ul a');
    expect((await headings.allTextContents()).map((text) => text.trim())).toEqual([
      'The first windows',
      'A list n',
      'The other method',
    ]);
    await headings.last().focus();
    await page.keyboard.press('Enter');
    const reached = page.locator('vidno-lesson-list ul a[aria-current=location]');
    await expect.poll(() => reached.textContent()).toContain('The other method');
    await expect
      .poll(() =>
        page
          .locator('article h3[data-place]')
          .last()
          .evaluate((e) => e.matches(':focus')),
      )
      .toBe(true);
    await page.waitForFunction(() => location.hash.includes('at=3'));
    expect(faults).toEqual([]);
  });

  it('goes to other lessons, and Back returns to the previous place', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    await readTo(page, 'second');
    await page.waitForFunction(() => location.hash.endsWith('step=60'));
    const before = await below(page, 'second');
    await page.getByRole('link', { name: 'Lesson second' }).first().click();
    await expect.poll(() => title(page)).toBe('second');
    await expect.poll(() => standing(page)).toEqual(['zbuffer', 0, undefined]);
    await page.goBack();
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, undefined]);
    expect(await title(page)).toContain('From windows');
    expect(Math.abs((await below(page, 'second')) - before)).toBeLessThan(60);
    expect(faults).toEqual([]);
  });

  it('opens over the page, even a small one, and closes after a choice', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first', {
      viewport: { width: 390, height: 844 },
    });
    const list = page.locator('vidno-lesson-list');
    expect(await list.isVisible()).toBe(false);
    await openContents(page);
    await list.getByRole('link', { name: 'The other method' }).click();
    await list.waitFor({ state: 'hidden' });
    await page.waitForFunction(() => location.hash.includes('at=3'));
  });
});

describe('previous and next', () => {
  it('lead from lesson to lesson that has a text, at the top and at the end', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const [top, end] = [page.locator('nav.short'), page.locator('nav.long')];
    expect(await top.getByRole('link').count()).toBe(1);
    await end.getByRole('link', { name: 'Next lesson Lesson second' }).click();
    await expect.poll(() => title(page)).toBe('second');
    expect(await end.getByRole('link').count()).toBe(1);
    await top.getByRole('link', { name: 'Previous lesson: Lesson first' }).click();
    await expect.poll(() => title(page)).toContain('From windows');
    expect(await scrolled(page)).toBe(0);
  });
});

describe('the address', () => {
  it('of a pin opens its run at its step, with the pin at the reading line', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first&at=scanline');
    await expect.poll(() => standing(page)).toEqual(['zbuffer', 33, 'scanline']);
    const line = await page
      .locator('.box')
      .evaluate((box) => [box.scrollTop, box.scrollHeight - box.clientHeight, box.clientHeight]);
    const [at = 0, most = 0, height = 0] = line;
    const above = readingLine(at, most, height) - (await below(page, 'scanline'));
    expect(above).toBeGreaterThan(0);
    expect(above).toBeLessThan(20);
    await settled(page);
    expect(await standing(page)).toEqual(['zbuffer', 33, 'scanline']);
    expect(faults).toEqual([]);
  });

  it('with a step stays there, whatever the text says', async () => {
    const { page } = await openReader(
      browser,
      '#lang=en&lesson=first&at=second&trace=small.warnock.signs&step=3',
    );
    await expect.poll(() => scrolled(page)).toBeGreaterThan(200);
    await settled(page);
    expect((await shown(page)).step).toBe(3);
  });

  it('of an old link, with a trace alone, shows the text of its lesson as well', async () => {
    const { page } = await openReader(browser, '#lang=en&trace=small.zbuffer.signs&step=4');
    await whole(page);
    expect(await title(page)).toContain('From windows');
    expect(await standing(page)).toEqual(['zbuffer', 4, undefined]);
  });

  it('with an unknown place is that of the lesson', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first&at=%3Cb%3E.2');
    expect(await standing(page)).toEqual(['warnock', 0, undefined]);
    expect(faults).toEqual([]);
  });
});

describe('the place in the text', () => {
  it('is kept when the language is switched, the window resized, the text hidden', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    await readTo(page, 'second');
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, 'second']);
    const before = await below(page, 'second');
    const isKept = async (): Promise<void> => {
      await expect
        .poll(async () => Math.abs((await below(page, 'second')) - before))
        .toBeLessThan(80);
      expect(await standing(page)).toEqual(['warnock', 60, 'second']);
    };
    await page.locator('vidno-languages [lang=ru]').click();
    await page.locator('article[lang=ru]').waitFor();
    await isKept();
    await page.locator('vidno-languages [lang=en]').click();
    await isKept();
    await page.setViewportSize({ width: 1250, height: 900 });
    await isKept();
    await page.keyboard.press('r');
    await page.locator('vidno-reader').waitFor({ state: 'hidden' });
    await page.waitForFunction(() => location.hash.includes('reader=off'));
    await page.getByRole('button', { name: 'Text' }).click();
    await isKept();
  });

  it('is out of reach while the run is presented', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    expect(await page.locator('vidno-reader').getAttribute('inert')).not.toBe(null);
    const covered = await page
      .locator('vidno-player')
      .evaluate((player) => player.getBoundingClientRect().width === innerWidth);
    expect(covered).toBe(true);
  });
});

describe('beside the text', () => {
  it.each([
    [390, 844],
    [820, 1180],
    [1024, 768],
    [1280, 800],
    [1440, 900],
    [1920, 1080],
  ])('at %s x %s px the run is in sight, and nothing is cut off', async (width, height) => {
    const { page, faults } = await openReader(browser, '#lang=ru&lesson=first&follow=on', {
      viewport: { width, height },
    });
    await readTo(page, 'first');
    await expect.poll(() => standing(page)).toEqual(['warnock', 5, 'first']);
    const size = await page.evaluate(() => {
      const { scrollWidth, scrollHeight } = document.documentElement;
      return [scrollWidth, scrollHeight];
    });
    // On a phone the header scrolls away, which leaves the picture nearly the whole width.
    const header = await page.locator('vidno-page-header').boundingBox();
    const isPhone = width < 500;
    expect(size[0]).toBe(width);
    expect(size[1]).toBeLessThanOrEqual(height + (isPhone ? (header?.height ?? 0) + 8 : 0));
    for (const part of ['vidno-picture', '.sentence', '.slider']) {
      const box = await page.locator(part).first().boundingBox();
      if (box === null) throw new Error(`${part} is not there`);
      expect(box.y, part).toBeGreaterThanOrEqual(0);
      expect(box.y + box.height, part).toBeLessThanOrEqual(height);
    }
    const picture = await page.locator('vidno-picture').boundingBox();
    expect(Math.min(picture?.width ?? 0, picture?.height ?? 0)).toBeGreaterThanOrEqual(320);
    const text = await page.locator('.box').boundingBox();
    expect(text?.height).toBeGreaterThan(0.3 * height);
    expect(faults).toEqual([]);
  });
});

const areaOf = (page: Page): Promise<Area> =>
  page.locator('vidno-player').evaluate((player) => {
    const { trace } = player as HTMLElementTagNameMap['vidno-player'];
    if (!trace) throw new Error('no trace');
    return trace.header.scene.area;
  });

describe('on a phone', () => {
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true };

  it.each([
    [390, 844],
    [360, 640],
    [844, 390],
    [820, 1180],
  ])('a touched pixel is described below the picture, at %s x %s px', async (width, height) => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first&step=1545', {
      viewport: { width, height },
      hasTouch: true,
    });
    const picture = page.locator('vidno-picture');
    const readout = page.locator('vidno-readout');
    await picture.locator('svg').first().tap();
    await expect
      .poll(async () => (await readout.locator('span').allInnerTexts()).join(' '))
      .toMatch(/^\(\d+, \d+\) .*#[0-9a-f]{6}$/);
    const [box, panel] = [await readout.boundingBox(), await picture.boundingBox()];
    const { x, y, height: rows } = await areaOf(page);
    const { y: end } = await spotOf(page, x, y + rows);
    expect(box?.y).toBeGreaterThanOrEqual(end);
    expect((box?.y ?? NaN) + (box?.height ?? NaN)).toBeLessThanOrEqual(
      (panel?.y ?? NaN) + (panel?.height ?? NaN),
    );
    expect(faults).toEqual([]);
  });

  it('the tools include the name and the settings of the run', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first', phone);
    const words = page.locator('vidno-run-words button');
    expect(await words.isVisible()).toBe(false);
    await page.getByRole('button', { name: 'Menu' }).tap();
    await words.tap();
    expect(await page.locator('vidno-run-words dl').innerText()).toContain('corrected');
  });

  it.each(['en', 'ru'])('without the text all controls of a lesson fit (%s)', async (lang) => {
    const { page, faults } = await openReader(
      browser,
      `#lang=${lang}&lesson=first&view=lesson&reader=off`,
      phone,
    );
    for (const part of [
      '.asides .exact',
      '.asides .predict',
      'vidno-travel select',
      '.step input',
    ]) {
      const box = await page.locator(`vidno-player ${part}`).first().boundingBox();
      expect(box?.x, part).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? NaN) + (box?.width ?? NaN), part).toBeLessThanOrEqual(390);
      expect((box?.y ?? NaN) + (box?.height ?? NaN), part).toBeLessThanOrEqual(844);
    }
    const { x, y, width } = await areaOf(page);
    const [left, right] = [await spotOf(page, x, y), await spotOf(page, x + width, y)];
    expect(right.x - left.x).toBeGreaterThanOrEqual(0.9 * 390);
    expect(faults).toEqual([]);
  });
});

describe('on paper', () => {
  const pages = async (page: Page): Promise<number> => {
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    return pdf.match(/\/Type\s*\/Page\b/g)?.length ?? 0;
  };

  it('the text is printed alone, with the answers and the numbers of the steps', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first', {
      colorScheme: 'dark',
    });
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    for (const part of ['article h2', '.answers', 'figure img', 'article math']) {
      expect(await page.locator(part).first().isVisible(), part).toBe(true);
    }
    for (const part of ['main', 'nav', 'vidno-page-header', '.bar', 'nav.long', 'details']) {
      expect(await page.locator(part).first().isVisible(), part).toBe(false);
    }
    const note = await pin(page, 'second').evaluate(
      (mark) => getComputedStyle(mark, '::after').content,
    );
    expect(note).toContain('step 60');
    const ink = await page
      .locator('article > p')
      .first()
      .evaluate((e) => getComputedStyle(e).color);
    expect(ink).toBe('rgb(0, 0, 0)');
    expect(faults).toEqual([]);
  });

  it('the answers stand at the end, each with the name of its question', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const answers = page.locator('.answers');
    expect(await answers.isVisible()).toBe(false);
    await page.emulateMedia({ media: 'print' });
    expect((await answers.innerText()).split(/\n+/)).toEqual([
      'Answers',
      'Question 1',
      'Three windows.',
    ]);
    const isLast = await answers.evaluate((e) => {
      const parts = [...(e.parentElement?.children ?? [])];
      return parts.slice(parts.indexOf(e)).every((part) => !part.matches('.question, .sources'));
    });
    expect(isLast).toBe(true);
  });

  it('the text is divided between its lines, although a sheet is as narrow as a small screen', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first', {
      viewport: { width: 700, height: 900 },
    });
    const contained = (): Promise<string> =>
      page.locator('vidno-reader').evaluate((reader) => getComputedStyle(reader).contain);
    expect(await contained()).toBe('size');
    await page.emulateMedia({ media: 'print' });
    expect(await contained()).toBe('none');
  });

  it('the text takes as many sheets as it needs, the run alone takes one', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    expect(await pages(page)).toBeGreaterThan(1);
    await page.keyboard.press('r');
    await page.locator('vidno-reader').waitFor({ state: 'hidden' });
    expect(await pages(page)).toBe(1);
  });
});
