import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { open, opened, sampleTrace } from './page.js';
import { asked, press, savedScore, stepOf, verdict } from './predict.js';

/**
 * The scene of lesson 14: W has x from 2 to 14 and the depth x / 16. Q is in front of it at 3/4, and S is behind both at
 * -1/2.
 */
const wall = sampleTrace('wall.weiler-atherton.signs');

describe('a reader of Weiler and Atherton’s algorithm', () => {
  it('continues only by answering, by keyboard alone', async () => {
    const { page, faults } = await open(browser, '#lang=en&ask=forced');
    await opened(page, 'wall.jsonl', wall);
    // W comes first, with 14/16, the last of the depths -1/2, 1/8, 3/4 and 7/8.
    await page.keyboard.press('End');
    await asked(page, 24);
    await press(page, '1', 'Tab', '4', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');

    // Q and S lie on both sides of the outline of W. Outside, S is a ring with two outlines, the third of the options 0, 1,
    // 2.
    await page.keyboard.press('q');
    await asked(page, 42);
    await press(page, '1', '2', 'Tab', '1', '2', 'Tab', '3', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');

    // S is behind W and Q is not, so W is processed again, after Q.
    await page.keyboard.press('q');
    await asked(page, 60);
    await press(page, '2', 'Tab', '2', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');
    await page.keyboard.press('q');
    await asked(page, 67);
    await press(page, '1', 'Tab', '1', '2', 'Enter');
    expect((await verdict(page)).at(-1)).toBe('Right.');
    expect(await savedScore(page)).toMatchObject({
      total: { asked: 4, right: 4, given_up: 0 },
      kinds: {
        sort: { right: 1 },
        parted: { right: 1 },
        behind: { right: 1 },
        stack: { right: 1 },
      },
    });
    expect(await violations(page)).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('answers where outlines enter and leave, and which way the walk goes', async () => {
    const { page, faults } = await open(browser, '#lang=ru&ask=free');
    await opened(page, 'wall.jsonl', wall);
    const choice = page.locator('vidno-predict .choice fieldset');
    const turn = (name: string): Promise<void> => choice.getByRole('checkbox', { name }).press(' ');
    await page.locator('vidno-side button.predict').press('Enter');
    for (const kind of await choice.locator('input').all()) {
      if (await kind.isChecked()) await kind.press(' ');
    }
    await turn('входы и выходы');
    await page.keyboard.press('q');
    // The outline of Q: (8, 14), (4, 14), entering W at (4, 12), then (4, 6), (8, 6), leaving it at (8, 12).
    await asked(page, 43);
    await press(page, '3', 'Tab', 'Tab', 'Tab', 'Tab', '6', 'Enter');
    expect(await verdict(page)).toEqual(['✓ верно', '✓ верно', 'Верно.']);

    await turn('входы и выходы');
    await turn('обход по контурам');
    await page.keyboard.press('q');
    // The outline of W along Q, from vertex 2 at (8, 12) to vertex 3 at (4, 12), and back along Q by the last points, 7 and
    // 8.
    await asked(page, 70);
    await press(page, 'Tab');
    await page.keyboard.type('3 7 8');
    await page.keyboard.press('Enter');
    expect((await verdict(page)).at(-1)).toBe('Верно.');
    const reasons = page.locator('vidno-question .reasons button');
    await reasons.last().press('Enter');
    expect(await stepOf(page)).toBe(79);
    expect(await violations(page)).toEqual([]);
    expect(faults).toEqual([]);
  });
});
