import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { edit, rerun, run } from './live.js';
import { cutOff, goTo, open, opened, sampleTrace } from './page.js';

const events = (name: string): readonly string[] =>
  sampleTrace(name).trim().split('\n').slice(1, -1);

/** The page at the step after the first event that matches the expression. */
async function openAt(name: string, event: RegExp, hash = '#lang=en'): Promise<Page> {
  const { page } = await open(browser, hash);
  await opened(page, name, Buffer.from(sampleTrace(name)));
  const step = events(name).findIndex((line) => event.test(line)) + 1;
  expect(step).toBeGreaterThan(0);
  await goTo(page, step);
  return page;
}

const said = (page: Page): Promise<string> => page.locator('.dock .sentence').innerText();

describe('a variant of the algorithm', () => {
  it('keeps three lists, which the panel shows', async () => {
    const page = await openAt('small.warnock-full.signs', /"e":"join".*"A".*"level":1/u);
    const list = (name: string) => page.locator(`vidno-warnock .list[aria-label="${name}"]`);
    expect((await list('Third').innerText()).trim()).toBe('B');
    expect((await list('Surrounding').innerText()).split(/\s+/u)).toEqual(['A', '1']);
    expect(await list('Outside').innerText()).toBe('empty');
  });

  it('draws the ray and says what it crosses', async () => {
    const page = await openAt('small.warnock-full.signs', /"e":"ray".*"counts":1/u);
    expect(await said(page)).toMatch(/crosses the ray: 1 so far\.$/u);
    expect(await page.locator('vidno-picture text.label').allTextContents()).toContain('1');
  });

  it('numbers the octants, and says what an edge turns by and the sum', async () => {
    const page = await openAt(
      'small.warnock-angles.signs',
      /"e":"octants","at":"OA4"/u,
      '#lang=ru',
    );
    expect(await said(page)).toContain('сумма +6');
    const notes = await page.locator('vidno-picture text.label').allTextContents();
    expect(notes).toEqual(expect.arrayContaining(['+4', '+2']));
  });

  it.each(['en', 'ru'])('names its three lists in full: %s', async (language) => {
    const page = await openAt('small.warnock-full.signs', /"e":"ray"/u, `#lang=${language}`);
    for (const width of [390, 1280, 1920]) {
      await page.setViewportSize({ width, height: 1080 });
      expect([width, await cutOff(page, 'vidno-warnock h4')]).toEqual([width, []]);
    }
  });

  it('is accessible', async () => {
    const { page } = await open(browser, '#lang=en');
    const name = 'small.warnock-vertex.signs';
    await opened(page, name, Buffer.from(sampleTrace(name)));
    await goTo(page, events(name).length >> 1);
    expect(await violations(page)).toEqual([]);
  });
});

describe('the library in the page', () => {
  it.each(['simplest', 'full', 'angles', 'vertex'])(
    'writes of a variant what the program wrote: %s',
    async (variant) => {
      const name = `small.warnock-${variant}.signs`;
      const { page, faults } = await open(browser, '#lang=en');
      await opened(page, name, Buffer.from(sampleTrace(name)));
      await edit(page);
      const detail = page.locator('vidno-run-form select[name=detail]');
      await rerun(page, () => detail.selectOption('windows'));
      const again = await rerun(page, () => detail.selectOption('signs'));
      expect(again.lines).toEqual(events(name));
      expect(faults).toEqual([]);
    },
  );

  it('offers each method with its rule, and says why it refuses a scene', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', sampleTrace('small.warnock.signs'));
    await edit(page);
    const method = page.locator('vidno-run-form select[name=method]');
    await rerun(page, () => method.selectOption('warnock-simplest'));
    expect((await run(page)).method).toBe('warnock-simplest');
    await method.selectOption('warnock-bodies');
    await page.locator('vidno-scene-panel .message.refused').waitFor();
    expect(await page.locator('vidno-scene-panel .message.refused').innerText()).toMatch(
      /^A: у него есть ребро/u,
    );
    expect(await page.locator('vidno-run-form .rule').innerText()).toMatch(
      /^Замкнутые выпуклые тела/u,
    );
  });
});
