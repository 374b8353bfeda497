import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { isOpen, open, openFile, opened, shown } from './page.js';

/** Milliseconds for a task on a machine under several times its capacity. On an idle machine a second is too long. */
const patience = 2500;

/** The side of the largest area, of which few states can be kept. */
const side = 16_384;

const header = (method: string, size: number, polygons: readonly object[]): object => ({
  format: 'vidno-trace/1',
  method,
  edition: 'corrected',
  kernel: 'double',
  detail: 'polygons',
  scene: {
    format: 'vidno-scene/1',
    name: 'Large',
    window: { x: 0, y: 0, width: size, height: size },
    background: '#ffffff',
    polygons,
  },
});

function polygonsOf(count: number): readonly object[] {
  const vertices = [
    [0, 0, 0],
    [8, 0, 0],
    [0, 8, 0],
  ];
  return Array.from({ length: count }, (_, i) => ({ id: `P${i}`, color: '#112233', vertices }));
}

function traceOf(first: object, events: readonly object[]): string {
  const end = { end: { events: events.length, picture: `sha256:${'0'.repeat(64)}` } };
  return [first, ...events, end].map((line) => `${JSON.stringify(line)}\n`).join('');
}

/** Records from now on how long the page's tasks take, in milliseconds. */
const watchTasks = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const tasks: number[] = [];
    Object.assign(window, { tasks });
    const observer = new PerformanceObserver((list) =>
      tasks.push(...list.getEntries().map(({ duration }) => duration)),
    );
    observer.observe({ type: 'longtask' });
  });

/** The longest task since the last call. */
const longestTask = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const { tasks } = window as unknown as { tasks: number[] };
    // A task that has just ended is reported with the next frame.
    for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
    return Math.round(Math.max(0, ...tasks.splice(0)));
  });

describe('a long operation does not block the page', () => {
  it('any step of a run in the largest area is shown', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const fills = Array.from({ length: 400_000 }, (_, i) => ({
      e: 'fill',
      at: 'W8',
      rect: [i % side, Math.floor(i / side), 1, 1],
      color: `#${i.toString(16).padStart(6, '0')}`,
    }));
    await opened(page, 'wide.jsonl', traceOf(header('warnock', side, polygonsOf(1)), fills));
    await watchTasks(page);
    for (const [key, goal] of [
      ['End', fills.length],
      ['ArrowLeft', fills.length - 1],
      ['Home', 0],
    ] as const) {
      await page.keyboard.press(key);
      const { step, sentence } = await shown(page);
      const longest = await longestTask(page);
      console.log(`step ${goal}: longest task ${longest} ms`);
      expect(step).toBe(goal);
      if (goal === fills.length) expect(sentence).toContain('#061a7f');
      expect(longest).toBeLessThan(patience);
    }
    expect(faults).toEqual([]);
  });

  it('a run of 20 000 polygons is opened and shown at its end', async () => {
    const count = 20_000;
    const { page, faults } = await open(browser, '#lang=en');
    const polygons = polygonsOf(count);
    const all = polygons.map((_, i) => [`P${i}`, false]);
    const leaving = Array.from({ length: count - 1 }, (_, i) => ({
      e: 'discard',
      at: 'PW3',
      polygon: `P${i}`,
    }));
    const whole = [0, 0, 8, 8];
    const events = [
      { e: 'push', at: 'W3', window: whole, apl: all },
      { e: 'pop', at: 'W5', window: whole },
      ...leaving,
    ];
    await watchTasks(page);
    await opened(page, 'many.jsonl', traceOf(header('warnock', 8, polygons), events));
    const opening = await longestTask(page);
    await page.keyboard.press('End');
    expect((await shown(page)).step).toBe(events.length);
    const ending = await longestTask(page);
    console.log(`20 000 polygons: longest task ${opening} ms as opened, ${ending} ms at the end`);
    expect(opening).toBeLessThan(patience);
    expect(ending).toBeLessThan(patience);

    // All of them can be chosen.
    const choice = page.locator('vidno-travel select');
    await choice.focus();
    await choice.selectOption(`polygon P${count - 3}`);
    await choice.blur();
    await page.keyboard.press(',');
    expect((await shown(page)).step).toBe(events.length - 1);
    expect(faults).toEqual([]);
  });

  it('the reading of a file can be stopped', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const skips = Array.from({ length: 1_500_000 }, () => ({
      e: 'skip',
      at: 'W13',
      window: [0, 0, 1, 1],
    }));
    const text = traceOf(header('warnock', 8, polygonsOf(1)), skips);
    await openFile(page, 'long.jsonl', text);
    await isOpen(page, 'long.jsonl');
    await page.locator('vidno-notice button').click();
    const notice = page.locator('vidno-notice .shortened');
    await notice.waitFor();
    const { length } = await shown(page);
    expect(length).toBeGreaterThan(0);
    expect(length).toBeLessThan(skips.length);
    expect(await notice.textContent()).toContain(`after line ${length + 1}.`);
    await page.keyboard.press('End');
    expect((await shown(page)).step).toBe(length);
    expect(faults).toEqual([]);
  });
});
