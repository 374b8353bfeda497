import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { openUrl, sampleTrace, small } from './page.js';

const dist = new URL('../dist/', import.meta.url).href;
const script = `${dist}vidno-player.js`;
const folder = mkdtempSync(join(tmpdir(), 'vidno-embed-'));
const evil = '<img src=x onerror=alert(1)>';

afterAll(() => {
  rmSync(folder, { recursive: true });
});

interface Opened {
  readonly page: Page;
  readonly faults: readonly string[];
}

/** A page of somebody's course, opened from disk. */
async function course(body: string, head = ''): Promise<Opened> {
  const file = join(folder, 'course.html');
  const start = `<!doctype html><html lang="en"><head><meta charset="utf-8">${head}<title>Course</title>`;
  writeFileSync(
    file,
    `${start}<script src="${script}"></script></head><body>${body}</body></html>`,
  );
  return openUrl(browser, pathToFileURL(file).href);
}

const block = `<script type="application/jsonl" id="run">${small.replaceAll('"A"', JSON.stringify(evil)).replaceAll('<', '\\u003c')}</script>`;

const step = (page: Page): Promise<number> =>
  page
    .locator('vidno-player')
    .evaluate((player) => (player as HTMLElement & { step: number }).step);

describe('the element', () => {
  it('shows a trace that the page contains, from the given step, in the given language', async () => {
    const { page, faults } = await course(
      `<vidno-player src="#run" step="3" lang="ru"></vidno-player>${block}`,
    );
    await page.locator('.sentence').waitFor();
    expect(await step(page)).toBe(3);
    expect(await page.locator('.sentence').textContent()).toMatch(/[а-я]/);
    expect(await page.locator('vidno-picture text').first().textContent()).toBe(evil);
    expect(await page.locator('img').count()).toBe(0);
    expect((await page.locator('vidno-player').boundingBox())?.height).toBe(576);
    expect(faults).toEqual([]);
  });

  it('with all controls stays within its place on a phone, and is scrolled there', async () => {
    const { page } = await course(
      `<p>Before</p><vidno-player src="#run" step="3"></vidno-player><p id="after">After</p>${block}`,
    );
    await page.setViewportSize({ width: 390, height: 844 });
    await page.locator('.sentence').waitFor();
    const after = page.locator('#after');
    await after.scrollIntoViewIfNeeded();
    const isCovered = await after.evaluate((e) => {
      const { x, y, width, height } = e.getBoundingClientRect();
      return document.elementFromPoint(x + width / 2, y + height / 2) !== e;
    });
    expect(isCovered).toBe(false);
    const player = page.locator('vidno-player');
    const [shown, all] = await player.evaluate((e) => [e.clientHeight, e.scrollHeight]);
    expect(shown).toBe(576);
    expect(all).toBeGreaterThan(576);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });

  it('shows a run of curves, and asks about it', async () => {
    const curves = sampleTrace('crossing.floating-horizon.signs');
    const { page, faults } = await course(
      `<vidno-player src="#curves" step="3" ask="forced"></vidno-player>
       <script type="application/jsonl" id="curves">${curves}</script>`,
    );
    await page.locator('.sentence').waitFor();
    expect(await page.locator('vidno-curve-picture').count()).toBe(1);
    await page.locator('.play').focus();
    await page.keyboard.press('End');
    await page.locator('vidno-question', { hasText: 'upper horizon' }).waitFor();
    expect(faults).toEqual([]);
  });

  it('stops at questions if asked to, but not with small controls', async () => {
    const { page } = await course(
      `<vidno-player src="#run" ask="forced"></vidno-player>
       <vidno-player src="#run" ask="forced" controls="small"></vidno-player>${block}`,
    );
    const players = page.locator('vidno-player');
    for (const player of await players.all()) {
      await player.locator('.sentence').waitFor();
      await player.locator('.play').focus();
      await page.keyboard.press('End');
    }
    const steps = await players.evaluateAll((all) =>
      all.map((each) => (each as HTMLElement & { step: number }).step),
    );
    expect(steps).toEqual([4, 1545]);
    await players.first().locator('vidno-question').waitFor();
    expect(await players.last().locator('vidno-question').count()).toBe(0);
  });

  it('goes no farther than from its first step to its last', async () => {
    const { page } = await course(
      `<vidno-player src="#run" from="10" to="20"></vidno-player>${block}`,
    );
    await page.locator('.sentence').waitFor();
    expect(await step(page)).toBe(10);
    await page.locator('.play').focus();
    await page.keyboard.press('End');
    expect(await step(page)).toBe(20);
    await page.keyboard.press('ArrowRight');
    expect(await step(page)).toBe(20);
    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    expect(await step(page)).toBe(10);
    const slider = page.locator('.slider');
    expect([await slider.getAttribute('min'), await slider.getAttribute('max')]).toEqual([
      '10',
      '20',
    ]);
  });

  it('plays by itself, at the given speed, to its last step', async () => {
    const { page } = await course(
      `<vidno-player src="#run" to="12" speed="300" play></vidno-player>${block}`,
    );
    await page.waitForFunction(
      () => (document.querySelector('vidno-player') as unknown as { step: number }).step === 12,
    );
    await page.locator('.play[aria-label="Play"]').waitFor();
  });

  it('follows attributes that change', async () => {
    const { page } = await course(`<vidno-player src="#run"></vidno-player>${block}`);
    await page.locator('.sentence').waitFor();
    await page.locator('vidno-player').evaluate((player) => {
      player.setAttribute('step', '7');
      player.setAttribute('lang', 'ru');
      player.setAttribute('controls', 'none');
    });
    await page.locator('vidno-transport').waitFor({ state: 'hidden' });
    expect(await step(page)).toBe(7);
    expect(await page.locator('.sentence').textContent()).toMatch(/[а-я]/);
    await page.locator('vidno-player').evaluate((player) => player.setAttribute('src', '#no'));
    await page.locator('vidno-notice').getByText('#no').waitFor();
  });

  it.each([
    ['full', true, true],
    ['small', true, false],
    ['none', false, false],
  ])('has the given controls: %s', async (controls, transport, side) => {
    const { page } = await course(
      `<vidno-player src="#run" controls="${controls}"></vidno-player>${block}`,
    );
    await page.locator('.sentence').waitFor();
    expect(await page.locator('vidno-transport').isVisible()).toBe(transport);
    expect(await page.locator('.side').isVisible()).toBe(side);
    await page.locator('vidno-picture > svg').focus();
    await page.keyboard.press('Escape');
    await page.locator('.procedures').focus();
    await page.keyboard.press('ArrowRight');
    expect(await step(page)).toBe(transport ? 1 : 0);
  });

  it.each([
    ['#nowhere', /#nowhere could not be read/],
    ['missing.jsonl', /missing.jsonl could not be read/],
    ['#text', /#text cannot be read as a trace\. Line 1/],
  ])('says in its place what is wrong: %s', async (src, message) => {
    const { page } = await course(
      `<vidno-player src="${src}"></vidno-player><script type="application/jsonl" id="text">hello</script>`,
    );
    await page.locator('vidno-notice p.failed').waitFor();
    expect(await page.locator('vidno-notice p.failed').textContent()).toMatch(message);
  });

  it('is as high as the sentence that says so', async () => {
    const { page } = await course(`<vidno-player src="#nowhere"></vidno-player>`);
    await page.locator('vidno-notice p.failed').waitFor();
    expect((await page.locator('vidno-player').boundingBox())?.height).toBeLessThan(100);
  });

  it('keeps the keys that it uses from the slides around it, and no others', async () => {
    const { page } = await course(
      `<vidno-player src="#run" controls="small"></vidno-player>${block}`,
      `<script>heard = []; addEventListener('keydown', ({ key }) => heard.push(key));</script>`,
    );
    await page.locator('.sentence').waitFor();
    await page.locator('.play').focus();
    // Step and menu keys are used; there is no panel to open or leave, and PageDown is a key of slides.
    for (const key of ['ArrowRight', ' ', ' ', 'c', 'c', 'Escape', 'x', 'PageDown']) {
      await page.keyboard.press(key);
    }
    expect(await page.evaluate('heard')).toEqual(['Escape', 'x', 'PageDown']);
  });

  const policy = (scripts: string): string =>
    `<meta http-equiv="Content-Security-Policy" content="worker-src 'none'; script-src ${scripts}">`;

  it('needs no more of the page’s policy than WebAssembly', async () => {
    const { page } = await course(
      `<vidno-player src="#run"></vidno-player>${block}`,
      policy("file: 'wasm-unsafe-eval'"),
    );
    await page.locator('.sentence').waitFor();
    await page.locator('.play').focus();
    await page.keyboard.press('End');
    expect(await step(page)).toBe(small.trim().split('\n').length - 2);
  });

  it.each([
    ['en', /^This page forbids WebAssembly.*script-src 'self' 'wasm-unsafe-eval'/],
    ['ru', /^Этой странице запрещён WebAssembly.*script-src 'self' 'wasm-unsafe-eval'/],
  ])('says how a policy allows WebAssembly, in %s', async (language, sentence) => {
    const { page } = await course(
      `<vidno-player src="#run" lang="${language}"></vidno-player>${block}`,
      policy('file:'),
    );
    await page.locator('vidno-notice p.failed').waitFor();
    expect(await page.locator('vidno-notice p.failed').textContent()).toMatch(sentence);
  });

  it('is accessible', async () => {
    const { page } = await course(
      `<h1>Course</h1><vidno-player src="#run" controls="small"></vidno-player>${block}`,
    );
    await page.locator('.sentence').waitFor();
    expect(await violations(page)).toEqual([]);
  });
});

describe('the page in a frame', () => {
  it('is moved by messages of the page around it, and tells it each step', async () => {
    const file = join(folder, 'slides.html');
    writeFileSync(
      file,
      `<!doctype html><script>told = []; addEventListener('message', ({ data }) => told.push(data.step));</script>
       <iframe width="800" height="450" src="${dist}index.html#embed&step=3"></iframe>`,
    );
    const { page } = await openUrl(browser, pathToFileURL(file).href);
    const frame = page.frameLocator('iframe');
    await frame.locator('.sentence').waitFor();
    const send = (message: unknown): Promise<void> =>
      page.evaluate((data) => frames[0]?.postMessage(data, '*'), message);
    const told = (): Promise<unknown> => page.evaluate('told');
    await send({ vidno: 'what' });
    await expect.poll(told).toEqual([3]);
    await send({ vidno: 'next' });
    await expect.poll(told).toEqual([3, 4]);
    await send({ vidno: 'previous' });
    await expect.poll(told).toEqual([3, 4, 3]);
    await send({ vidno: 'go', step: 12 });
    await send({ vidno: 'go', step: 'far' });
    await expect.poll(told).toEqual([3, 4, 3, 12]);
    await frame.locator('.procedures').press('ArrowRight');
    await expect.poll(told).toEqual([3, 4, 3, 12, 13]);
  });

  it('is the player alone, configured by the address', async () => {
    const first = await openUrl(browser, `${dist}index.html`);
    const button = first.page.locator('vidno-lesson-list button').first();
    if ((await button.count()) === 0) return;
    const trace = (await button.getAttribute('data-trace')) ?? '';
    const hash = `#embed&trace=${trace}&from=5&to=30&step=12&lang=ru&controls=small&speed=2`;
    const file = join(folder, 'frame.html');
    writeFileSync(
      file,
      `<!doctype html><iframe width="800" height="450" src="${dist}index.html${hash}"></iframe>`,
    );
    const { page, faults } = await openUrl(browser, pathToFileURL(file).href);
    const frame = page.frameLocator('iframe');
    await frame.locator('.sentence').waitFor();
    for (const hidden of ['header', 'nav', 'h2']) {
      expect(await frame.locator(hidden).first().isVisible()).toBe(false);
    }
    const player = frame.locator('vidno-player');
    const box = await player.evaluate((e) => {
      const { x, y, width, height } = e.getBoundingClientRect();
      return [x, y, width, height, document.documentElement.scrollHeight];
    });
    expect(box).toEqual([0, 0, 800, 450, 450]);
    expect(await frame.locator('input[type=number]').inputValue()).toBe('12');
    expect(await frame.locator('.sentence').textContent()).toMatch(/[а-я]/);
    await frame.locator('.procedures').press('Home');
    await expect.poll(() => frame.locator('input[type=number]').inputValue()).toBe('5');
    expect(faults).toEqual([]);
  });
});
