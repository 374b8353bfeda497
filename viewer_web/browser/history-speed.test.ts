import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { spotOf } from './live.js';
import { open, opened, repeated, sampleTrace, small } from './page.js';

/** Reports, for each click, the time until the history was complete and on the page. */
const watch = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const times: number[] = [];
    Object.assign(window, { times });
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const answer = (): Element | null | undefined =>
      player?.shadowRoot
        ?.querySelector('vidno-side')
        ?.shadowRoot?.querySelector('vidno-history')
        ?.shadowRoot?.querySelector('.why ~ .entries[aria-busy=false]');
    const onClick = (): void => {
      const start = performance.now();
      const look = (): void => {
        if (answer()) times.push(Math.round(performance.now() - start));
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    };
    window.addEventListener('click', onClick, { capture: true });
  });

const timesOf = (page: Page): Promise<readonly number[]> =>
  page.evaluate(() => (window as unknown as { times: number[] }).times);

describe('a trace of 300 000 events', () => {
  it.each([
    ['warnock', repeated(small, /"at":"W3"/, 300_000)],
    ['zbuffer', repeated(sampleTrace('small.zbuffer.signs'), /"e":"polygon"/, 300_000)],
  ])('%s gives the history of a pixel soon after the click', async (name, text) => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, `${name}.jsonl`, text);
    await watch(page);
    const clicks = 5;
    for (let i = 1; i <= clicks; i++) {
      // The area is 5 x 4 pixels, from (2, -1) on.
      const { x, y } = await spotOf(page, 2 + (5 * i) / (clicks + 1), 1 / 3);
      await page.mouse.click(x, y);
      await page.waitForFunction(
        (n) => (window as unknown as { times: number[] }).times.length === n,
        i,
      );
    }
    const times = [...(await timesOf(page))].sort((a, b) => a - b);
    console.log(`${name}: ${times.join(', ')} ms from click to history`);
    // A busy machine takes many times as long. This limit only catches gross failures.
    expect(times[0]).toBeLessThan(3000);
  });
});
