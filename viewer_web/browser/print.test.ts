import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { goTo, open, opened, small } from './page.js';

/** A trace that only pushes windows on the stack, this number of times. */
function stackOf(length: number): string {
  const [header = '', ...lines] = small.split('\n');
  const push = lines.find((line) => line.includes('"e":"push"')) ?? '';
  const end = { end: { events: length, picture: `sha256:${'0'.repeat(64)}` } };
  return [header, ...Array.from({ length }, () => push), JSON.stringify(end), ''].join('\n');
}

describe('on paper', () => {
  it.each([390, 1280])('a step is one sheet of A4, from a window of %s px', async (width) => {
    const { page, faults } = await open(browser, '#lang=ru', { viewport: { width, height: 800 } });
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    expect(pdf.match(/\/Type\s*\/Page\b/g)).toHaveLength(1);
    // 210 x 297 mm in points, as whole numbers.
    expect(pdf).toMatch(/\/MediaBox \[0 0 59[45][.\d]* 84[12][.\d]*\]/);
    expect(faults).toEqual([]);
  });

  it('has the picture, the sentence, the state and the current lines, black on white', async () => {
    const { page } = await open(browser, '#lang=en', { colorScheme: 'dark' });
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await page.locator('.pixels').first().waitFor();
    for (const shown of ['main h2', 'vidno-picture', '.sentence', 'vidno-listing .now', '.side']) {
      expect(await page.locator(shown).first().isVisible(), shown).toBe(true);
    }
    for (const hidden of [
      'header',
      'nav',
      'vidno-transport',
      'vidno-legend',
      '.choice',
      'canvas',
    ]) {
      expect(await page.locator(hidden).first().isVisible(), hidden).toBe(false);
    }
    const ink = await page.locator('.sentence').evaluate((e) => getComputedStyle(e).color);
    expect(ink).toBe('rgb(0, 0, 0)');
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    await page.locator('.pixels').first().waitFor({ state: 'detached' });
  });

  it('has no offer of the tour in a lesson', async () => {
    const { page } = await open(browser, '#lang=en');
    await page.emulateMedia({ media: 'print' });
    await page.locator('.greeting').waitFor({ state: 'attached' });
    expect(await page.locator('.greeting').isVisible()).toBe(false);
  });

  it('says how many rows of a long list do not fit on the sheet', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'stack.jsonl', stackOf(12));
    await goTo(page, 12);
    const rows = page.locator('vidno-warnock .windows tr');
    expect(await rows.count()).toBe(12);
    await page.emulateMedia({ media: 'print' });
    expect(await rows.filter({ visible: true }).count()).toBe(9);
    const more = page.locator('vidno-warnock .stack .on-paper');
    expect(await more.textContent()).toBe('and 3 more');
    const sheet = await page.locator('.side').boundingBox();
    const last = await more.boundingBox();
    expect((last?.y ?? NaN) + (last?.height ?? NaN)).toBeLessThanOrEqual(
      (sheet?.y ?? NaN) + (sheet?.height ?? NaN),
    );
  });
});
