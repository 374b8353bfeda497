import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser, settled } from './browser.js';
import { edit, editing, openScene, rerun, run, scene, square, title, triangle } from './live.js';
import type { Run } from './live.js';
import { goTo, open, openContents, opened, openFile, sampleTrace, shown, small } from './page.js';
import { openReader, pin, standing } from './reader.js';

/** Moves the first vertex of an edited scene by its field, and returns the next run. */
async function moveVertex(page: Page): Promise<Run> {
  await page.locator('vidno-polygon-form .corners').first().click();
  const x = page.getByLabel('x of vertex 1').first();
  return rerun(page, async () => {
    await x.fill('2');
    await x.press('Enter');
  });
}

const step = async (page: Page): Promise<number> => (await shown(page)).step;

describe('Back', () => {
  it('undoes jumps by number, key, link and lesson, but not single steps', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    await goTo(page, 40);
    await page.locator(title).click();
    await settled(page);
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    await settled(page);
    await page.keyboard.press('End');
    await settled(page);
    await pin(page, 'scanline').click();
    await expect.poll(() => standing(page)).toEqual(['zbuffer', 33, 'scanline']);
    await settled(page);
    await openContents(page);
    await page.locator('[data-trace="small.warnock.signs"]').first().click();
    await settled(page);

    const end = small.trim().split('\n').length - 2;
    for (const [method, at] of [
      ['zbuffer', 33],
      ['warnock', end],
      ['warnock', 43],
      ['warnock', 0],
    ] as const) {
      await page.goBack();
      await expect.poll(async () => (await standing(page)).slice(0, 2)).toEqual([method, at]);
      await settled(page);
    }
    await page.goForward();
    await expect.poll(() => step(page)).toBe(43);
    expect(faults).toEqual([]);
  });

  it('undoes jumps in a file of the reader’s own, which no address can name', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await settled(page);
    for (const at of [40, 300, 7]) {
      await goTo(page, at);
      await settled(page);
      await page.locator(title).click();
      await settled(page);
    }
    for (const at of [300, 40]) {
      await page.goBack();
      await expect.poll(() => step(page)).toBe(at);
      await settled(page);
    }
    await page.goForward();
    await expect.poll(() => step(page)).toBe(300);
    expect(faults).toEqual([]);
  });

  it('returns to a file of the reader’s own from a lesson', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    await opened(page, 'small.jsonl', sampleTrace('small.zbuffer.signs'));
    await goTo(page, 40);
    await page.locator(title).click();
    await settled(page);
    await openContents(page);
    await page.locator('[data-trace="small.warnock.signs"]').first().click();
    await expect.poll(async () => (await standing(page))[0]).toBe('warnock');
    await settled(page);
    await page.goBack();
    await expect.poll(async () => (await standing(page)).slice(0, 2)).toEqual(['zbuffer', 40]);
    await settled(page);
    await page.goForward();
    await expect.poll(async () => (await standing(page))[0]).toBe('warnock');
    expect(faults).toEqual([]);
  });

  it('keeps an edited scene at its step, and asks before discarding one', async () => {
    const { page, faults } = await editing(browser);
    await settled(page);
    const changed = await moveVertex(page);
    await settled(page);
    await goTo(page, 30);
    await settled(page);
    await page.goBack();
    await expect.poll(() => step(page)).toBe(0);
    expect(await run(page)).toEqual(changed);

    // A lesson was open before. The reader first stays, then saves, and the scene is closed.
    const question = page.locator('vidno-discard dialog[open]');
    await page.goBack();
    await question.getByRole('button', { name: 'Stay here' }).click();
    expect(await run(page)).toEqual(changed);
    await page.waitForFunction(() => location.hash.includes('scene='));
    await openFile(page, 'small.jsonl', small);
    await question.waitFor();
    await page.keyboard.press('Escape');
    await question.waitFor({ state: 'detached' });
    expect(await run(page)).toEqual(changed);
    await openContents(page);
    await page.locator('vidno-lesson-list a[href]').nth(2).click();
    await question.waitFor();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      question.getByRole('button', { name: 'Save the scene' }).click(),
    ]);
    expect(download.suggestedFilename()).toBe('two.json');
    await expect.poll(async () => (await run(page)).polygons).not.toEqual(changed.polygons);
    expect(faults).toEqual([]);
  });
});

describe('an edited scene', () => {
  it('is not lost by a reload without a question', async () => {
    const { page } = await editing(browser);
    const changed = await moveVertex(page);
    // The reload never ends, since the reader stays.
    const [question] = await Promise.all([
      page.waitForEvent('dialog'),
      page.evaluate(() => {
        setTimeout(() => location.reload());
      }),
    ]);
    expect(question.type()).toBe('beforeunload');
    await question.dismiss();
    expect(await run(page)).toEqual(changed);
  });

  it('is still asked about after a reload and after Back', async () => {
    const { page, faults } = await editing(browser);
    page.on('dialog', (dialog) => void dialog.accept());
    const changed = await moveVertex(page);
    await settled(page);
    const question = page.locator('vidno-discard dialog[open]');
    const leave = async (answer: string): Promise<void> => {
      await openContents(page);
      await page.locator('vidno-lesson-list a[href]').nth(2).click();
      await question.getByRole('button', { name: answer }).click();
      await expect.poll(() => run(page)).not.toEqual(changed);
      await settled(page);
    };

    await page.reload();
    await expect.poll(() => run(page)).toEqual(changed);
    await leave('Discard');
    await page.goBack();
    await expect.poll(() => run(page)).toEqual(changed);
    await settled(page);
    await leave('Save the scene');
    await page.goBack();
    await expect.poll(() => run(page)).toEqual(changed);
    await settled(page);
    await openContents(page);
    await page.locator('vidno-lesson-list a[href]').nth(2).click();
    await expect.poll(() => run(page)).not.toEqual(changed);
    expect(faults).toEqual([]);
  });

  it('is left by the last of several moves', async () => {
    const { page, faults } = await openReader(browser, '#lang=en&lesson=first');
    const first = await run(page);
    for (const at of [40, 80]) {
      await goTo(page, at);
      await page.locator(title).click();
      await settled(page);
    }
    await openScene(page, scene([triangle, square]));
    await edit(page);
    await settled(page);
    const changed = await moveVertex(page);
    await settled(page);
    const question = page.locator('vidno-discard dialog[open]');
    for (const answer of ['Stay here', 'Discard']) {
      for (let i = 0; i < 2; i++) {
        await page.goBack();
        await question.waitFor();
        await settled(page);
      }
      expect(await run(page)).toEqual(changed);
      await question.getByRole('button', { name: answer }).click();
      await question.waitFor({ state: 'detached' });
      await settled(page);
    }
    await expect.poll(() => run(page)).toEqual(first);
    expect(faults).toEqual([]);
  });

  it('does not ask before anything was changed', async () => {
    const { page } = await editing(browser);
    await page.locator('vidno-polygon-form .corners').first().click();
    const asked: string[] = [];
    page.on('dialog', (dialog) => {
      asked.push(dialog.type());
      void dialog.accept();
    });
    await page.reload();
    await page.locator('vidno-listing').waitFor();
    expect(asked).toEqual([]);
  });
});

describe('a link to something missing', () => {
  it.each([
    ['#lang=en&trace=no-such-run&step=3', 'no-such-run'],
    ['#lang=en&lesson=99-none', '99-none'],
  ])('says so: %s', async (hash, name) => {
    const { page, faults } = await open(browser, hash);
    const notice = page.locator('vidno-notice [role=alert]');
    expect(await notice.textContent()).toContain(`“${name}”, which this page does not contain`);
    expect(faults).toEqual([]);
  });
});
