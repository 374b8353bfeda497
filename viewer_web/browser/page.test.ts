import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { goTo, lessonTraces, open, openLesson, opened, shown, small, whole } from './page.js';
import { sample } from './sample.js';

/** Steps to the end of the run and back by keyboard. */
async function playThrough(page: Page): Promise<void> {
  await page.keyboard.press('ArrowRight');
  expect((await shown(page)).step).toBe(1);
  await page.keyboard.press('End');
  const last = await shown(page);
  expect(last.step).toBe(last.length);
  expect(last.sentence).not.toBe('');
  await page.keyboard.press('ArrowLeft');
  expect((await shown(page)).step).toBe(last.length - 1);
  await page.keyboard.press('Home');
  expect((await shown(page)).step).toBe(0);
}

const isOfCurves = (trace: string): boolean => trace.includes('floating-horizon');

/** Opens the history of the pixel in the middle. */
async function askHistory(page: Page, trace: string): Promise<void> {
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  // The history of a column has no last entry: several curves may cross it.
  const said = isOfCurves(trace) ? '.entries' : '.why, vidno-history .last:disabled';
  await page.locator(`vidno-history ${said}`).waitFor();
  await page.keyboard.press('Escape');
  expect(await page.locator('vidno-history .entries').innerText()).not.toMatch(
    /undefined|null|NaN|\[object/,
  );
}

describe('each lesson', () => {
  it('opens, plays to its end by keyboard and back, shows a pixel’s history, and does nothing else', async () => {
    const { page, faults } = await open(browser, '#lang=ru');
    for (const trace of sample(await lessonTraces(page), 3)) {
      await openLesson(page, trace);
      await whole(page);
      await playThrough(page);
      await askHistory(page, trace);
    }
    expect(faults).toEqual([]);
  });
});

describe('the controls', () => {
  it('step forward and back through every step alike', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const steps = 60;
    const forward: unknown[] = [await shown(page)];
    for (let i = 0; i < steps; i++) {
      await page.keyboard.press('ArrowRight');
      forward.push(await shown(page));
    }
    for (let i = steps - 1; i >= 0; i--) {
      await page.keyboard.press('ArrowLeft');
      expect(await shown(page)).toEqual(forward[i]);
    }
    expect(faults).toEqual([]);
  });

  it('jump, by number, slider and ten steps', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 77);
    expect((await shown(page)).step).toBe(77);
    await page.locator('.slider').fill('300');
    expect((await shown(page)).step).toBe(300);
    await page.locator('.slider').blur();
    await page.keyboard.press('Shift+ArrowRight');
    expect((await shown(page)).step).toBe(310);
  });

  it('leave typed text alone while the run plays', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    // The field is filled in several events, and must not change between them.
    await page.clock.install({ time: 0 });
    await page.clock.pauseAt(3_600_000);
    await page.keyboard.press('Space');
    const field = page.locator('.dock input[type=number]');
    await field.fill('77');
    const { step } = await shown(page);
    await page.clock.resume();
    await expect.poll(async () => (await shown(page)).step).toBeGreaterThan(step);
    expect(await field.inputValue()).toBe('77');
    await field.press('Enter');
    await expect.poll(async () => (await shown(page)).step).toBeGreaterThanOrEqual(77);
    await page.context().close(); // with its clock
  });

  it('play and pause', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.clock.install();
    await page.keyboard.press('Space');
    await page.waitForFunction(() => {
      const app = document.querySelector('vidno-app');
      return (app?.shadowRoot?.querySelector('vidno-player')?.step ?? 0) >= 2;
    });
    expect(await page.locator('.sentence').getAttribute('aria-live')).toBe('off');
    await page.keyboard.press('Space');
    const { step } = await shown(page);
    await page.clock.runFor('00:10');
    expect((await shown(page)).step).toBe(step);
    expect(await page.locator('.sentence').getAttribute('aria-live')).toBe('polite');
    await page.context().close(); // with its clock
  });

  it('show the map of keys', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('?');
    expect(await page.locator('vidno-keys dialog').isVisible()).toBe(true);
    await page.keyboard.press('Escape');
    expect(await page.locator('vidno-keys dialog').isVisible()).toBe(false);
  });

  it('can all be reached by Tab', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    const reached = new Set<string>();
    for (let i = 0; i < 60; i++) {
      await page.keyboard.press('Tab');
      reached.add(await focused(page));
    }
    for (const label of ['First step', 'Step back', 'Play', 'Step forward', 'Last step', 'Step']) {
      expect([...reached]).toContain(label);
    }
  });
});

const focused = (page: Page): Promise<string> =>
  page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    return element?.getAttribute('aria-label') ?? element?.textContent.trim() ?? '';
  });

describe('the address', () => {
  it('reopens a lesson at its step', async () => {
    const { page: first } = await open(browser, '#lang=en');
    const last = (await lessonTraces(first)).at(-1);
    if (last === undefined) return;
    await openLesson(first, last);
    await whole(first);
    await first.keyboard.press('End');
    // The picture is compared with the exact one meanwhile.
    await expect.poll(async () => (await shown(first)).sentence).not.toContain('being compared');
    const before = await shown(first);
    expect(before.step).toBe(before.length);
    await first.waitForFunction((step) => location.hash.endsWith(`step=${step}`), before.step);
    const { page, faults } = await open(browser, new URL(first.url()).hash);
    await page.locator('.title h2').getByText(/./).waitFor();
    await whole(page);
    await expect.poll(() => shown(page)).toEqual(before);
    expect(faults).toEqual([]);
  });
});

describe('the language', () => {
  it('is switched and kept in the address with trace and step', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('ArrowRight');
    const english = await shown(page);
    await page.locator('vidno-languages [lang=ru]').click();
    const russian = await shown(page);
    expect(russian.step).toBe(english.step);
    expect(russian.sentence).toMatch(/[а-я]/);
    expect(english.sentence).not.toMatch(/[а-я]/);
    expect(await page.evaluate(() => document.documentElement.lang)).toBe('ru');
    await page.waitForFunction(() => location.hash.includes('lang=ru'));
    expect(faults).toEqual([]);
  });
});
