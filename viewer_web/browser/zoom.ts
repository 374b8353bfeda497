import type { Page } from 'playwright-core';
import { expect } from 'vitest';
import { spotOf } from './live.js';

export const stage = 'vidno-picture > svg';

/** CSS pixels per pixel of the picture. */
export const scaleOf = (page: Page): Promise<number> =>
  page.locator(stage).evaluate((svg) => (svg as SVGSVGElement).getScreenCTM()?.a ?? 0);

/** Where a point of the picture is on the page, rounded as mouse events report it. */
export async function dotOf(page: Page, x: number, y: number): Promise<{ x: number; y: number }> {
  const spot = await spotOf(page, x, y);
  return { x: Math.round(spot.x), y: Math.round(spot.y) };
}

/** Turns the wheel over a place of the plane to enlarge the picture by a factor. */
export async function wheel(page: Page, x: number, y: number, by: number): Promise<void> {
  const { x: left, y: top } = await dotOf(page, x, y);
  await page.mouse.move(left, top);
  const before = await scaleOf(page);
  // Wheel events report their distance in device pixels.
  const ratio = await page.evaluate(() => devicePixelRatio);
  await page.mouse.wheel(0, -300 * Math.log2(by) * ratio);
  await expect.poll(() => scaleOf(page)).not.toBe(before);
}
