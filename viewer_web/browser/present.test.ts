import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { faultsInHall, presentIn } from './hall.js';
import { sample } from './sample.js';
import { goTo, open, opened, sampleTrace, shown, small } from './page.js';

async function presenting(hash = '#lang=en'): Promise<{ page: Page; faults: readonly string[] }> {
  const { page, faults } = await open(browser, hash, { viewport: { width: 1280, height: 720 } });
  await opened(page, 'small.jsonl', small);
  await goTo(page, 60);
  await page.locator('input[type=number]').blur();
  await page.keyboard.press('f');
  await page.locator('.corner').waitFor();
  return { page, faults };
}

const step = async (page: Page): Promise<number> => (await shown(page)).step;

/** A run of each method, and those whose state differs. */
const runs = [
  'small.warnock.signs',
  'small.warnock.windows',
  'small.warnock-simplest.signs',
  'small.warnock-full.signs',
  'small.warnock-vertex.signs',
  'small.warnock-angles.signs',
  'edges.warnock-edges.signs',
  'body.warnock-bodies.signs',
  'small.zbuffer.signs',
  'wedge.weiler-atherton.signs',
  'hills.floating-horizon.signs',
];

describe('the lecture hall', () => {
  it.each(['en', 'ru'])('has everything in sight, and nothing moves, in %s', async (language) => {
    const { page, faults } = await open(browser, `#lang=${language}&view=lesson`);
    const found: string[] = [];
    for (const run of runs) {
      await opened(page, `${run}.jsonl`, sampleTrace(run));
      const steps = sample(await presentIn(page, language), 4);
      for (const [width, height] of [
        [1024, 768],
        [1280, 720],
        [1920, 1080],
      ] as const) {
        await page.setViewportSize({ width, height });
        const wrong = await faultsInHall(page, steps);
        found.push(...wrong.map((each) => `${run}, ${width} x ${height}: ${each}`));
      }
    }
    expect(found).toEqual([]);
    expect(faults).toEqual([]);
  });
});

describe('the presentation', () => {
  it('is controlled by a presenter remote', async () => {
    const { page, faults } = await presenting();
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    expect(await step(page)).toBe(62);
    await page.keyboard.press('PageUp');
    expect(await step(page)).toBe(61);
    expect(await page.locator('.corner').textContent()).toContain('61 / ');
    expect(faults).toEqual([]);
  });

  it('blackens the screen with B or a full stop until any key or click, which does nothing else', async () => {
    const { page } = await presenting();
    const lights = [
      () => page.keyboard.press('PageDown'),
      () => page.keyboard.press('.'),
      () => page.keyboard.press('Escape'),
      () => page.keyboard.press('Enter'), // which does nothing in a hall
      () => page.mouse.click(300, 300),
    ];
    for (const [i, light] of lights.entries()) {
      await page.keyboard.press(i % 2 === 0 ? 'b' : '.');
      const curtain = await page.locator('.curtain').boundingBox();
      expect(curtain).toEqual({ x: 0, y: 0, width: 1280, height: 720 });
      await light();
      await page.locator('.curtain').waitFor({ state: 'detached' });
    }
    expect(await step(page)).toBe(60);
    expect(await page.locator('.corner').isVisible()).toBe(true);
  });

  it('points with P, draws with P again, and erases with Escape or the third P', async () => {
    const { page, faults } = await presenting();
    const spot = page.locator('vidno-pen circle');
    const stroke = page.locator('vidno-pen polyline');
    const drag = async (): Promise<void> => {
      await page.mouse.move(200, 200);
      await page.mouse.down();
      await page.mouse.move(260, 240);
      await page.mouse.up();
    };
    await page.keyboard.press('p');
    await page.mouse.move(300, 100);
    const box = await spot.boundingBox();
    expect([
      (box?.x ?? NaN) + (box?.width ?? NaN) / 2,
      (box?.y ?? NaN) + (box?.height ?? NaN) / 2,
    ]).toEqual([expect.closeTo(300, 0), expect.closeTo(100, 0)]);
    expect(box?.height).toBeGreaterThan(720 / 25);
    await page.keyboard.press('p');
    await drag();
    expect(await spot.count()).toBe(0);
    expect(await stroke.getAttribute('points')).toMatch(/^200,200 .*260,240$/);
    // What is drawn remains while the run goes on.
    await page.keyboard.press('PageDown');
    expect(await step(page)).toBe(61);
    expect(await stroke.count()).toBe(1);
    await page.keyboard.press('Escape');
    await page.locator('vidno-pen').waitFor({ state: 'detached' });
    for (const press of ['p', 'p']) await page.keyboard.press(press);
    expect(await stroke.count()).toBe(0);
    await drag();
    await page.keyboard.press('p');
    await page.locator('vidno-pen').waitFor({ state: 'detached' });
    expect(await page.locator('.corner').isVisible()).toBe(true);
    expect(faults).toEqual([]);
  });

  it('is left by Escape, F or its button', async () => {
    const { page, faults } = await presenting();
    for (const leave of [
      () => page.keyboard.press('Escape'),
      () => page.keyboard.press('f'),
      () => page.getByRole('button', { name: 'Leave the presentation' }).click(),
    ]) {
      await leave();
      await page.locator('.corner').waitFor({ state: 'detached' });
      expect(await page.locator('vidno-transport').isVisible()).toBe(true);
      await page.getByRole('button', { name: 'Present' }).click();
      await page.locator('.corner').waitFor();
    }
    expect(faults).toEqual([]);
  });

  it('lets a pixel be pointed at', async () => {
    const { page } = await presenting();
    const box = await page.locator('vidno-picture').boundingBox();
    if (box === null) throw new Error('no picture');
    // The area is 5 x 4 from (2, -1). Its middle is the corner of four pixels; a point close to it is in the pixel (4, 1).
    await page.mouse.click(box.x + box.width / 2 + 3, box.y + box.height / 2 + 3);
    const pixel = await page
      .locator('vidno-player')
      .evaluate((player: HTMLElementTagNameMap['vidno-player']) => player.pixel);
    expect(pixel).toEqual([4, 1]);
  });

  it('is kept in the link', async () => {
    const { page } = await open(browser, '#lang=en');
    if ((await page.locator('vidno-lesson-list button').count()) === 0) return;
    await page.locator('vidno-listing').waitFor();
    await page.keyboard.press('f');
    await page.waitForFunction(() => location.hash.includes('view=present'));
    const again = await open(browser, new URL(page.url()).hash);
    await again.page.locator('.corner').waitFor();
    await again.page.keyboard.press('Escape');
    await again.page.waitForFunction(() => !location.hash.includes('view=present'));
    expect(again.faults).toEqual([]);
  });

  it('is accessible, and separates the line from the sentence for those who hear it', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    await page.locator('input[type=number]').blur();
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    expect(await violations(page)).toEqual([]);
    expect(await page.locator('.sentence').ariaSnapshot()).toContain('PW5 : В левом верхнем углу');
  });
});
