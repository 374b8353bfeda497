import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { editing, handle, openScene, rerun, scene, spotOf, triangle } from './live.js';
import { goTo, open, opened, small } from './page.js';
import type { Opened } from './page.js';
import { dotOf, scaleOf, stage, wheel } from './zoom.js';

async function openSmall(deviceScaleFactor = 1, hasTouch = false): Promise<Opened> {
  const found = await open(browser, '#lang=en', { deviceScaleFactor, hasTouch });
  await opened(found.page, 'small.jsonl', small);
  return found;
}

const chosen = (page: Page): Promise<readonly number[] | null> =>
  page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.pixel ? [...player.pixel] : null;
  });

describe('the picture', () => {
  it('is enlarged around the pointer by the wheel, and moved by a drag, which does not choose a pixel', async () => {
    const { page } = await openSmall();
    const before = await spotOf(page, 5, 2);
    await wheel(page, 5, 2, 4);
    const after = await spotOf(page, 5, 2);
    // The mouse is up to half a CSS pixel away from the place, and so is the place three pixels further when enlarged.
    expect(Math.abs(after.x - before.x)).toBeLessThanOrEqual(1.5);
    expect(Math.abs(after.y - before.y)).toBeLessThanOrEqual(1.5);
    const press = await dotOf(page, 5, 2);
    await page.mouse.move(press.x, press.y);
    await page.mouse.down();
    await page.mouse.move(press.x + 20, press.y - 10, { steps: 4 });
    await page.mouse.up();
    const moved = await spotOf(page, 5, 2);
    expect(moved.x - after.x).toBeCloseTo(20, 0);
    expect(moved.y - after.y).toBeCloseTo(-10, 0);
    expect(await chosen(page)).toBeNull();
  });

  it('takes a press that moves by 3 CSS pixels as a click', async () => {
    const { page } = await openSmall();
    await wheel(page, 5.5, 2.5, 4);
    const { x, y } = await dotOf(page, 5.5, 2.5);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 3, y);
    await page.mouse.up();
    expect(await chosen(page)).toEqual([5, 2]);
  });

  it('is enlarged and moved by two fingers', async () => {
    const { page } = await openSmall(1, true);
    const fit = await scaleOf(page);
    const { x, y } = await spotOf(page, 4.5, 1);
    const session = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', half: number): Promise<unknown> =>
      session.send('Input.dispatchTouchEvent', {
        type,
        touchPoints:
          type === 'touchEnd'
            ? []
            : [
                { x: x - half, y, id: 0 },
                { x: x + half, y, id: 1 },
              ],
      });
    await touch('touchStart', 20);
    for (const half of [24, 30, 40, 50, 60]) await touch('touchMove', half);
    await touch('touchEnd', 0);
    await expect.poll(async () => (await scaleOf(page)) / fit).toBeCloseTo(3, 1);
    const after = await spotOf(page, 4.5, 1);
    expect(after.x).toBeCloseTo(x, 0);
    expect(after.y).toBeCloseTo(y, 0);
    expect(await chosen(page)).toBeNull();
  });

  it('is enlarged and made whole again by buttons', async () => {
    const { page } = await openSmall();
    const fit = await scaleOf(page);
    const whole = page.getByRole('button', { name: 'Whole picture' });
    expect(await whole.getAttribute('aria-disabled')).toBe('true');
    await page.getByRole('button', { name: 'Larger' }).click();
    await expect.poll(() => scaleOf(page)).toBeCloseTo(1.5 * fit, 3);
    await page.getByRole('button', { name: 'Larger' }).click();
    await page.getByRole('button', { name: 'Smaller' }).click();
    await expect.poll(() => scaleOf(page)).toBeCloseTo(1.5 * fit, 3);
    await whole.click();
    await expect.poll(() => scaleOf(page)).toBeCloseTo(fit, 3);
    expect(await whole.getAttribute('aria-disabled')).toBe('true');
  });

  it('is enlarged by keys, which change the speed elsewhere, and follows the cursor', async () => {
    const { page } = await openSmall();
    const fit = await scaleOf(page);
    const speed = page.getByRole('combobox', { name: 'Speed' });
    const before = await speed.inputValue();
    await page.keyboard.press('p');
    for (let i = 0; i < 3; i++) await page.keyboard.press('+');
    await expect.poll(() => scaleOf(page)).toBeCloseTo(1.5 ** 3 * fit, 3);
    expect(await speed.inputValue()).toBe(before);
    for (let i = 0; i < 8; i++) await page.keyboard.press('ArrowRight');
    const box = await page.locator('vidno-picture').boundingBox();
    const { x, y } = await spotOf(page, 7, 1); // the right side of the last column
    expect(x).toBeGreaterThan(box?.x ?? NaN);
    expect(x).toBeLessThanOrEqual((box?.x ?? 0) + (box?.width ?? 0));
    expect(y).toBeGreaterThan(box?.y ?? NaN);
    await page.keyboard.press('-');
    await expect.poll(() => scaleOf(page)).toBeCloseTo(1.5 ** 2 * fit, 3);
    await page.keyboard.press('0');
    await expect.poll(() => scaleOf(page)).toBeCloseTo(fit, 3);
    await page.keyboard.press('Escape');
    await page.keyboard.press('+');
    expect(await speed.inputValue()).not.toBe(before);
  });

  it('keeps its zoom from step to step', async () => {
    const { page } = await openSmall();
    await wheel(page, 5, 2, 4);
    const before = await page.locator(stage).getAttribute('viewBox');
    for (const step of [300, 7, 900]) {
      await goTo(page, step);
      expect(await page.locator(stage).getAttribute('viewBox')).toBe(before);
    }
  });

  it('is accessible when zoomed (WCAG 2.2 AA)', async () => {
    const { page } = await openSmall();
    await wheel(page, 5, 2, 4);
    expect(await violations(page)).toEqual([]);
  });
});

describe('a scene that is edited', () => {
  it('is dragged at its zoomed place, and the zoom stays', async () => {
    const { page, faults } = await editing(browser);
    await wheel(page, 6, 1.5, 2);
    const before = await page.locator(stage).getAttribute('viewBox');
    const from = await spotOf(page, 6, 1);
    const to = await spotOf(page, 5.5, 2.25);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    const dragged = await rerun(page, () => page.mouse.move(to.x, to.y));
    await page.mouse.up();
    expect(dragged.polygons[0]?.vertices[1]).toEqual([5.5, 2.25, 0]);
    expect(await page.locator(stage).getAttribute('viewBox')).toBe(before);
    expect(faults).toEqual([]);
  });

  it('scrolls to a corner that gets the focus; there + adds a corner', async () => {
    const { page } = await editing(browser);
    await wheel(page, 2, 2, 6);
    const fit = await scaleOf(page);
    await page.locator(handle(1, 2)).focus();
    const box = await page.locator('vidno-picture').boundingBox();
    await expect
      .poll(async () => (await spotOf(page, 7, 7)).x)
      .toBeLessThanOrEqual((box?.x ?? 0) + (box?.width ?? 0));
    const split = await rerun(page, () => page.keyboard.press('+'));
    expect(split.polygons[1]?.vertices).toHaveLength(5);
    expect(await scaleOf(page)).toBe(fit);
  });

  it('is shown whole again when its area changes', async () => {
    const { page } = await editing(browser);
    await wheel(page, 5, 2, 3);
    await openScene(page, scene([triangle], 16));
    await expect.poll(() => page.locator(stage).getAttribute('class')).toBeNull();
    expect(await page.locator(stage).getAttribute('viewBox')).toContain('-');
  });
});
