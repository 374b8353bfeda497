import { describe, expect, it } from 'vitest';
import { evil, sampleLesson } from '../src/testing/lessons.js';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { openContents, opened, showsAnother, shown, small } from './page.js';
import { openReader, pin, readTo, scrolled, standing } from './reader.js';

describe('the text of a lesson', () => {
  it('is followed by the run while scrolling, into another run too, and back', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    expect(await standing(page)).toEqual(['warnock', 0, undefined]);
    for (const [place, now] of [
      ['first', ['warnock', 5, 'first']],
      ['second', ['warnock', 60, 'second']],
      ['scanline', ['zbuffer', 33, 'scanline']],
      ['second', ['warnock', 60, 'second']],
    ] as const) {
      await readTo(page, place);
      await expect.poll(() => standing(page)).toEqual(now);
    }
    expect(faults).toEqual([]);
  });

  it('does not pull back a reader who steps through the run, until another pin is reached', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    await readTo(page, 'first');
    await expect.poll(() => standing(page)).toEqual(['warnock', 5, 'first']);
    await page.keyboard.press('ArrowRight');
    const before = await scrolled(page);
    await page.mouse.wheel(0, 20);
    await expect.poll(() => scrolled(page)).toBe(before + 20);
    await page.mouse.wheel(0, -20);
    await expect.poll(() => scrolled(page)).toBe(before);
    await settled(page);
    expect((await shown(page)).step).toBe(6);
    await readTo(page, 'second');
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, 'second']);
  });

  it('goes to a pin at once by a click or Enter, and does not move', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    await readTo(page, 'second');
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, 'second']);
    await pin(page, 'scanline').scrollIntoViewIfNeeded();
    await settled(page); // the run has followed
    const before = await scrolled(page);
    await pin(page, 'scanline').click();
    await expect.poll(() => standing(page)).toEqual(['zbuffer', 33, 'scanline']);
    expect(await scrolled(page)).toBe(before);
    await pin(page, 'second').focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, 'second']);
  });

  it('is followed only if the reader asks for it, which the address remembers', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    await readTo(page, 'second');
    await page.waitForFunction(() => /at=second.*step=0/.test(location.hash));
    await settled(page);
    expect(await standing(page)).toEqual(['warnock', 0, undefined]);
    await openContents(page);
    const follow = page.getByRole('checkbox', { name: 'Follow the text' });
    await follow.click();
    await expect.poll(() => standing(page)).toEqual(['warnock', 60, 'second']);
    await page.waitForFunction(() => location.hash.includes('follow=on'));
    await follow.click();
    await page.waitForFunction(() => !location.hash.includes('follow='));
  });

  it('is passed through by Tab, which changes neither the run nor its step', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&follow=on');
    await page.locator('vidno-reader .box').focus();
    const focused = (): Promise<string | null> =>
      page.evaluate(() => {
        const root = document.querySelector('vidno-app')?.shadowRoot;
        const mark = root?.querySelector('vidno-reader')?.shadowRoot?.activeElement;
        return mark?.getAttribute('data-place') ?? null;
      });
    const seen = new Set<string | null>();
    while (!seen.has('scanline')) {
      await page.keyboard.press('Tab');
      seen.add(await focused());
      await settled(page);
      expect(await standing(page)).toEqual(['warnock', 0, undefined]);
    }
    expect(seen).toContain('second');
    await page.keyboard.press('Enter');
    await expect.poll(() => standing(page)).toEqual(['zbuffer', 33, 'scanline']);
  });

  it('is chosen from a list by keyboard, which keeps the focus', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const list = page.locator('vidno-reader .bar select');
    await list.focus();
    for (const [key, lesson] of [
      ['ArrowDown', 'second'],
      ['ArrowUp', 'first'],
    ] as const) {
      await page.keyboard.press(key);
      await page.waitForFunction((id) => location.hash.includes(`lesson=${id}`), lesson);
      await expect.poll(() => list.evaluate((e: HTMLSelectElement) => e.value)).toBe(lesson);
      await expect.poll(() => list.evaluate((e) => e.matches(':focus'))).toBe(true);
    }
  });

  it('leaves the arrows to the run after it was chosen from the list', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const list = page.locator('vidno-reader .bar select');
    await list.focus();
    await showsAnother(page, () => list.selectOption('second'));
    await expect.poll(() => list.evaluate((e) => e.matches(':focus'))).toBe(true);
    await page.keyboard.press('ArrowRight');
    expect((await shown(page)).step).toBe(1);
    await page.keyboard.press('ArrowLeft');
    expect((await shown(page)).step).toBe(0);
    expect(await list.inputValue()).toBe('second');
  });

  it('is chosen together with a run from the same list', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    const list = page.locator('vidno-reader .bar select');
    const runs = list.locator('optgroup[label="Runs of this lesson"] option');
    const ids = await runs.evaluateAll((all) =>
      all.map((each) => (each as HTMLOptionElement).value),
    );
    expect(ids.length).toBeGreaterThan(1);
    for (const id of ids.reverse()) {
      await showsAnother(page, () => list.selectOption(id));
      expect(new URLSearchParams(new URL(page.url()).hash.slice(1)).get('trace')).toBe(id);
      expect(await list.inputValue()).toBe('first');
    }
    expect(faults).toEqual([]);
  });

  it('is absent for a lesson without one, and for a file of the reader’s own', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=third');
    expect(await page.locator('vidno-reader').count()).toBe(0);
    expect(await page.getByRole('button', { name: 'Text' }).count()).toBe(0);
    await openContents(page);
    await page.getByRole('link', { name: 'Lesson first' }).click();
    await page.locator('vidno-reader h2').waitFor();
    await opened(page, 'small.jsonl', small);
    expect(await page.locator('vidno-reader').count()).toBe(0);
  });

  it('has formulas, tables, figures, code and questions', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    const fraction = page.locator('p math mfrac').first();
    expect(await fraction.evaluate((e) => [e.namespaceURI, e.textContent])).toEqual([
      'http://www.w3.org/1998/Math/MathML',
      '12',
    ]);
    expect(await page.locator('.formula math').first().textContent()).toBe('ax+by+cz+d=0');
    expect(await page.locator('.formula math').first().getAttribute('display')).toBe('block');
    expect(await page.locator('figure img').getAttribute('alt')).toBe('Two windows');
    const size = await page
      .locator('figure img')
      .evaluate((image: HTMLImageElement) => [image.naturalWidth, image.naturalHeight]);
    expect(size).toEqual([80, 60]);
    expect(await page.locator('figure').nth(1).locator('figcaption').textContent()).toBe(
      'Without a drawing',
    );
    expect(await page.locator('td.right').textContent()).toBe('1');
    expect(await page.locator('article > pre').textContent()).toBe('int i = 0; // <b>');
    expect(faults).toEqual([]);
  });

  it('states below its title the time, what comes first, its terms and its goals', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    const frame = page.getByRole('region', { name: 'About this lesson' });
    await page.locator('details.about summary').click();
    const facts = await frame.locator('dd').allInnerTexts();
    expect(facts.map((text) => text.replaceAll(/\s+/g, ' ').trim())).toEqual([
      '25 minutes, without the exercises',
      'Lesson second Not here Lines.',
      'depth',
    ]);
    expect(await frame.getByRole('link').allInnerTexts()).toEqual(['Lesson second']);
    expect(await frame.locator('.label + ul li').allInnerTexts()).toEqual(['split W13', 'count']);
    expect(await violations(page)).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('leaves room to press each of its new terms', async () => {
    const polygons = ['outside', 'inside', 'intersecting', 'surrounding'].map(
      (relation) => `${relation} polygon`,
    );
    const terms = [...polygons, 'window', 'depth', 'box test', 'surround test'];
    const blocks = terms.map((term) => ({
      is: 'paragraph',
      text: [{ is: 'strong', text: [term] }, '.'],
    }));
    const story = { title: ['Relations'], blocks };
    const lesson = sampleLesson({ story: { en: story, ru: story } });
    const { page } = await openReader(browser, '#lang=en&lesson=first', {}, lesson);
    expect(await page.locator('.frame vidno-term').count()).toBe(terms.length);
    expect(await violations(page)).toEqual([]);
  });

  it('prints the lines of the procedures, as the edition has them, in its language', async () => {
    for (const [language, depth] of [
      ['en', 'Depth of a plane'],
      ['ru', 'Глубина плоскости'],
    ] as const) {
      const { page } = await openReader(browser, `#lang=${language}&lesson=first`);
      const listing = page.locator('article .listing');
      expect(await listing.locator('.title').allInnerTexts()).toContain(depth);
      const lines = (await listing.locator('li').allInnerTexts()).map((text) =>
        text.replaceAll(/\s+/g, ' ').trim(),
      );
      expect(lines).toEqual([
        'PW7 if 0 < k < 4: hasSurround := false X-W3'.replace(
          'if',
          language === 'en' ? 'if' : 'если',
        ),
        'D1 z := −(a·x + b·y + d) / c',
      ]);
    }
  });

  it('lists its sources, with the translation in that language', async () => {
    const { page } = await openReader(browser, '#lang=ru&lesson=first');
    const sources = page.locator('.sources li');
    expect((await sources.innerText()).replaceAll(/\s+/g, ' ').trim()).toBe(
      'D. F. Rogers (1998). Procedural Elements. McGraw-Hill, глава 4. Роджерс Д. Основы.',
    );
    expect(await sources.getByRole('link').getAttribute('href')).toBe('https://example.org/rogers');
  });

  it('has exercises without answers if the lesson was built without them', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const exercise = page.getByRole('region', { name: 'Exercise 1' });
    expect(await exercise.innerText()).toContain('Compute it.');
    expect(await exercise.locator('details').count()).toBe(0);
  });

  it('hides an answer until it is asked for, by keyboard as well', async () => {
    // The run would otherwise follow the text, which scrolls to the question.
    const { page } = await openReader(browser, '#lang=en&lesson=first&follow=off');
    const answer = page.locator('.answer');
    expect(await answer.isVisible()).toBe(false);
    await page.locator('vidno-reader details:not(.about) summary').focus();
    await page.keyboard.press('Space');
    await answer.waitFor();
    await page.keyboard.press('Enter');
    await answer.waitFor({ state: 'hidden' });
    expect((await shown(page)).step).toBe(0);
  });

  it('lets a command be copied', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first', {
      permissions: ['clipboard-read', 'clipboard-write'],
    });
    const command = page.locator('vidno-command', { hasText: 'vidno methods' });
    await command.getByRole('button', { name: 'Copy' }).click();
    await command.getByRole('button', { name: 'Copied' }).waitFor();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('vidno methods');
  });

  it('is plain text, whatever a stranger has put into it', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    expect(await page.locator('article h2').textContent()).toContain(evil);
    expect(await page.locator('article img[onerror]').count()).toBe(0);
    expect(faults).toEqual([]);
  });

  it('is refused in a sentence if it is invalid, and the runs remain', async () => {
    const wrong = sampleLesson({ pins: { first: { run: 'run', step: -1 } } });
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first', {}, wrong);
    expect(await page.locator('vidno-reader [role=alert]').textContent()).toMatch(
      /^\s*The text of this lesson cannot be read at pins\.first\.step: a whole number/,
    );
    await page.keyboard.press('ArrowRight');
    expect((await shown(page)).step).toBe(1);
    await openContents(page);
    await page.locator('[data-trace="small.zbuffer.signs"]').click();
    await expect.poll(async () => (await standing(page))[0]).toBe('zbuffer');
    expect(faults).toEqual([]);
  });

  it.each([1440, 390])('can be used by everyone (%s px)', async (width) => {
    const viewport = { width, height: 844 };
    const { page } = await openReader(browser, '#lang=ru', { viewport });
    await pin(page, 'first').click();
    await page.locator('vidno-reader details:not(.about) summary').click();
    expect(await violations(page)).toEqual([]);
  });
});
