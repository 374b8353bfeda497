import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { goTo, open, opened, sampleTrace, small } from './page.js';
import { asked, press, savedScore, stepOf, verdict } from './predict.js';

describe('a reader who predicts freely', () => {
  it('asks, answers, reads the reasons, tries again and saves the score, by mouse', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.getByRole('button', { name: 'Predict' }).click();
    const next = page.getByRole('button', { name: 'Next question' });
    await next.click();
    await asked(page, 4);
    const form = page.locator('vidno-question');
    await form.getByRole('button', { name: 'Check' }).click();
    await form.getByText('Answer each part first.').waitFor();
    await form.getByRole('checkbox', { name: 'A', exact: true }).check();
    await form.getByRole('checkbox', { name: 'B', exact: true }).check();
    await form.getByRole('radio', { name: /^A / }).check();
    await form.getByRole('radio', { name: 'split' }).check();
    await form.getByRole('button', { name: 'Check' }).click();
    expect(await verdict(page)).toEqual(['✓ right', '✗ wrong', '✓ right', 'Not quite.']);
    expect(await form.locator('.right').allTextContents()).toEqual(['Correct: none is found']);
    const reasons = await form.locator('.reasons span:first-child').allTextContents();
    expect(reasons).toContain('B is nearer at 3 of 4 corners (top left, top right, bottom right).');
    expect(reasons).toContainEqual(
      expect.stringMatching(/^At the top left B is nearer: .* > 0\.1\.$/u),
    );
    expect(reasons.slice(-2)).toEqual([
      '2 polygons counted in the window; none is known to hide the others.',
      'None of the simple cases: the window is split.',
    ]);

    await form.getByRole('button', { name: 'Try again' }).click();
    await form.getByRole('radio', { name: 'none is found' }).check();
    await form.getByRole('button', { name: 'Check' }).click();
    expect((await verdict(page)).at(-1)).toBe('Right.');
    await form.getByRole('button', { name: /^None of the simple cases/ }).click();
    expect(await stepOf(page)).toBe(50);
    expect(await page.locator('vidno-question .result').isVisible()).toBe(true);

    await next.click();
    await page.locator('vidno-question h3:focus').waitFor();
    await form.getByRole('button', { name: 'I don’t know' }).click();
    expect((await verdict(page)).at(-1)).toBe('Not answered.');
    expect(await page.locator('vidno-predict .score b').first().textContent()).toBe(
      '0 of 2 right on the first try',
    );
    await page.getByRole('textbox', { name: 'Your name' }).fill('Ada');
    expect(await savedScore(page)).toMatchObject({
      format: 'vidno-score/1',
      name: 'Ada',
      total: { asked: 2, right: 0, given_up: 1 },
      runs: [
        {
          scene: 'A square, a triangle and a slope',
          events: 1545,
          answers: [
            { step: 4, kind: 'window', way: 'free', right: false, tries: 2 },
            { given_up: true, way: 'free' },
          ],
        },
      ],
    });
    expect(faults).toEqual([]);
  });

  it('can pass a question, which is then not counted', async () => {
    const { page } = await open(browser, '#lang=en&ask=free');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('q');
    await asked(page, 4);
    await page.keyboard.press('ArrowRight');
    expect(await stepOf(page)).toBe(5);
    expect(await page.locator('vidno-question').count()).toBe(0);
    expect(await page.locator('vidno-predict .score').count()).toBe(0);
    for (const kind of await page.locator('vidno-predict fieldset input').all())
      await kind.uncheck();
    await page.locator('vidno-predict').getByRole('checkbox', { name: 'clipping' }).check();
    await page.locator('vidno-predict .next').click();
    await page.getByText('No more questions of these kinds').waitFor();
  });
});

describe('a reader who must answer', () => {
  it('continues only by answering, by keyboard alone', async () => {
    const { page, faults } = await open(browser, '#lang=en&ask=forced');
    await opened(page, 'small.jsonl', small);
    // The window (2, -1) 8 x 8: both polygons stay, neither hides the other, and it is split.
    await page.keyboard.press('End');
    await asked(page, 4);
    await press(page, 'ArrowRight', 'Shift+ArrowRight', ']', '.', 'End', ' ');
    expect(await stepOf(page)).toBe(4);
    await page.locator('.slider').focus();
    await press(page, 'PageUp', 'End');
    await expect.poll(() => page.locator('.slider').inputValue()).toBe('4');
    await goTo(page, 700);
    expect(await stepOf(page)).toBe(4);
    expect(await page.locator('input[type=number]').inputValue()).toBe('4');
    await page.locator('.slider').focus();
    await press(page, 'Home');
    await page.getByRole('button', { name: 'A question waits at step 4' }).focus();
    await press(page, 'Enter');
    await asked(page, 4);
    await press(page, '1', '2', 'Tab', '3', 'Tab', '5', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');

    // The corner (6, -1) and A, the square from (1, -2) to (8, 4): the corner is on the same side of all four edges.
    await page.keyboard.press('End');
    await asked(page, 70);
    await press(page, '1', 'Tab', '+', '+', '+', '+', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');

    // z of B at the corners of (6, -1) 4 x 4 is (8.8, 4.8, 11.6, 7.6) / 19.5, compared with 0.1.
    await page.keyboard.press('q');
    await asked(page, 93);
    await press(page, '1', '2', '3', '4', 'Tab', '1', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');
    expect(await savedScore(page)).toMatchObject({
      total: { asked: 3, right: 3, given_up: 0 },
      kinds: { window: { right: 1 }, inside: { right: 1 }, corners: { right: 1 } },
    });
    expect(faults).toEqual([]);
  });

  it('is stopped while it plays, and orders the active edges', async () => {
    const { page } = await open(browser, '#lang=ru&ask=forced&speed=300');
    await opened(page, 'small.jsonl', sampleTrace('small.zbuffer.signs'));
    await page.keyboard.press(' ');
    // A is the square from (1, -2) to (8, 4). From its first row on, its edges 3 and 1 are active, from x = 1 to x = 8. The last
    // row of the area is 2.
    await asked(page, 13);
    await press(page, '2', '3', 'Tab', 'Tab');
    await page.keyboard.type('1 3');
    for (const cell of ['1', '2', '8', '2']) {
      await page.keyboard.press('Tab');
      await page.keyboard.type(cell);
    }
    await page.keyboard.press('Enter');
    expect(await verdict(page)).toEqual(['✓ верно', '✗ неверно', '✓ верно', 'Не совсем.']);
    expect(await page.locator('vidno-question .right').textContent()).toBe('Верно: 3 1');
  });

  it('finds the answer nowhere on the page', async () => {
    const { page } = await open(browser, '#lang=en&ask=forced&layer=exact&pixel=3,0');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('End');
    await asked(page, 4);
    expect(await page.locator('vidno-slider .veil').isVisible()).toBe(true);
    expect(await page.locator('.slider').getAttribute('aria-valuetext')).toBe('Step 4 of 1545');
    await page.locator('vidno-slider .strip').hover({ position: { x: 300, y: 10 } });
    expect(await page.locator('vidno-slider .tip').count()).toBe(0);
    expect(await page.locator('vidno-layers select').inputValue()).toBe('picture');
    await page.locator('vidno-side button.pixel').click();
    expect(await page.locator('vidno-history .entries').count()).toBe(0);
  });

  it('is set up by a link, which the page makes', async () => {
    const { page } = await open(
      browser,
      '#lang=ru&view=workbench&trace=09-usual-mistakes.warnock.double.corrected.signs&step=0',
    );
    await page.locator('vidno-side button.predict').click();
    await page.getByRole('checkbox', { name: 'Останавливать и спрашивать' }).check();
    await expect.poll(() => page.url()).toContain('ask=forced');
    await page.reload();
    await page
      .getByRole('checkbox', { name: 'Останавливать и спрашивать', checked: true })
      .waitFor();
    await page.keyboard.press('End');
    await page.locator('vidno-question h3:focus').waitFor();
  });
});

describe('questions', () => {
  const looks = [390, 1280, 1920].flatMap((width) =>
    (['en', 'ru'] as const).map((language) => ({ width, language })),
  );
  it.each(looks)('are accessible ($language, $width px)', async ({ width, language }) => {
    const viewport = { width, height: width < 500 ? 844 : 1080 };
    const { page } = await open(browser, `#lang=${language}&ask=forced`, { viewport });
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('End');
    await asked(page, 4);
    const boxes = await page
      .locator('vidno-question :is(label, button)')
      .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON() as DOMRect));
    for (const box of boxes) {
      expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(24);
      expect(box.right).toBeLessThanOrEqual(width);
    }
    // Where the page scrolls, elements under the time controls cannot be reached before scrolling.
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    expect(await violations(page)).toEqual([]);
    await page.locator('vidno-question .to-do button').last().click();
    await page.locator('vidno-question .result').waitFor();
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    expect(await violations(page)).toEqual([]);
  });
});
