import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { goTo, open, opened, placesOf, sampleTrace, small, widthOf } from './page.js';
import { openReader } from './reader.js';

describe('the layout', () => {
  it.each(['en', 'ru'])('clips and moves nothing at any width, in %s', async (language) => {
    const { page, faults } = await open(browser, `#lang=${language}`);
    await opened(page, 'small.jsonl', small);
    for (const width of [390, 768, 1024, 1280, 1920]) {
      await page.setViewportSize({ width, height: width < 500 ? 844 : 1080 });
      const places = new Set<string>();
      for (const step of [0, 1, 10, 60, 200, 500, 900]) {
        await goTo(page, step);
        places.add(await placesOf(page, 'vidno-player :is(.picture, .listing, .dock, .sentence)'));
        expect(await widthOf(page)).toBe(width);
      }
      expect([...places], `at ${width} px`).toHaveLength(1);
    }
    expect(faults).toEqual([]);
  });

  it('fits the run with all panels on one screen, where there is room beside the picture', async () => {
    const viewport = { width: 1024, height: 768 };
    const { page } = await open(browser, '#lang=ru', { viewport });
    await opened(page, 'small.jsonl', small);
    for (const part of ['vidno-player', '.picture', '.listing', '.side', '.dock']) {
      const box = await page.locator(part).first().boundingBox();
      if (box === null) throw new Error(`${part} is not there`);
      expect(box.y + box.height, part).toBeLessThanOrEqual(viewport.height);
    }
  });

  it.each([390, 1024])('brings a panel into sight that is opened, at %d px', async (width) => {
    const viewport = { width, height: 768 };
    const { page } = await open(browser, '#lang=en', { viewport });
    await goTo(page, 300);
    await page.locator('input[type=number]').blur();
    await page.keyboard.press('x');
    // The list of decisions arrives later, and the panel grows.
    await page.locator('vidno-findings table').waitFor();
    const head = await page.locator('vidno-side .choice').boundingBox();
    if (head === null) throw new Error('no panel');
    expect(head.y).toBeGreaterThanOrEqual(0);
    expect(head.y + head.height).toBeLessThan(viewport.height - 200);
  });

  it('keeps the controls in sight where the page scrolls', async () => {
    const viewport = { width: 390, height: 844 };
    const { page } = await open(browser, '#lang=ru', { viewport });
    await opened(page, 'small.jsonl', small);
    const player = await page.locator('vidno-player').boundingBox();
    const dock = await page.locator('vidno-player .dock').boundingBox();
    if (player === null || dock === null) throw new Error('no run is shown');
    expect(player.y + player.height).toBeGreaterThan(viewport.height);
    expect(dock.y + dock.height).toBeLessThanOrEqual(viewport.height);
  });
});

/** By how many CSS pixels the controls stick out of their row, and the dock covers the picture. */
const overlaps = (page: Page): Promise<{ readonly out: number; readonly covered: number }> =>
  page.evaluate(() => {
    const boxOf = (e: Element | null | undefined): DOMRect => {
      if (!e) throw new Error('no run is shown');
      return e.getBoundingClientRect();
    };
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const find = (part: string): Element | null | undefined =>
      player?.shadowRoot?.querySelector(part);
    const transport = find('vidno-transport');
    const controls =
      transport?.shadowRoot?.querySelectorAll('button, select, input, .number') ?? [];
    const rights = [...controls]
      .filter((e) => e.checkVisibility() && getComputedStyle(e).clipPath === 'none')
      .map((e) => e.getBoundingClientRect().right);
    const picture = find('vidno-picture-panel')?.shadowRoot?.querySelector('vidno-picture');
    return {
      out: Math.max(0, Math.round(Math.max(...rights) - boxOf(transport).right)),
      covered: Math.max(0, Math.round(boxOf(picture).bottom - boxOf(find('.dock')).top)),
    };
  });

// At the end of a run the button is longest: "Play from the start".
describe.each(['en', 'ru'])('at the end of a run, in %s', (language) => {
  it.each(['lesson', 'workbench'])(
    'the controls fit and cover no part of the picture at any width, in the view %s',
    async (view) => {
      const { page } = await openReader(browser, `#lang=${language}&lesson=first&view=${view}`, {
        viewport: { width: 320, height: 844 },
      });
      await page.keyboard.press('End');
      for (const text of ['with the text', 'without it']) {
        for (let width = 320; width <= 1500; width += 40) {
          await page.setViewportSize({ width, height: 844 });
          await settled(page);
          expect(await overlaps(page), `${text}, ${width} px`).toEqual({ out: 0, covered: 0 });
        }
        await page.keyboard.press('r');
      }
    },
  );
});

it('opens at its top on a small phone, with more than fits', async () => {
  const { page } = await openReader(browser, '#lang=en', { viewport: { width: 360, height: 640 } });
  await page.locator('vidno-player').waitFor();
  await settled(page);
  expect(await page.evaluate(() => document.documentElement.scrollHeight)).toBeGreaterThan(640);
  expect(await page.evaluate(() => scrollY)).toBe(0);
});

/** The steps, out of about 200, at which the sentence does not fit into its box, each with its sentence. */
const cutSentences = (page: Page): Promise<readonly string[]> =>
  page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const box = player?.shadowRoot?.querySelector('.sentence');
    if (!player || !box) throw new Error('no sentence');
    const cut: string[] = [];
    const stride = Math.ceil(player.length / 200);
    for (let step = 1; step <= player.length; step += stride) {
      player.moveTo(step);
      await player.updateComplete;
      if (box.scrollHeight > box.clientHeight + 1) cut.push(`${step}: ${box.textContent}`);
    }
    return cut;
  });

it.each(['en', 'ru'])('on a phone every sentence fits, in %s', async (language) => {
  const viewport = { width: 390, height: 844 };
  const { page } = await open(browser, `#lang=${language}`, { viewport });
  for (const trace of [
    'small.warnock.signs',
    'small.zbuffer.signs',
    'small.warnock-angles.signs',
    'edges.warnock-edges.signs',
    'wedge.weiler-atherton.signs',
    'hills.floating-horizon.signs',
  ]) {
    await opened(page, `${trace}.jsonl`, sampleTrace(trace));
    expect(await cutSentences(page), trace).toEqual([]);
  }
});

it.each([390, 1440])(
  'an address that names nothing gives a message in sight, at %d px',
  async (width) => {
    const { page } = await open(browser, '#lang=en&trace=nothing', {
      viewport: { width, height: 844 },
    });
    const notice = page.locator('vidno-notice p');
    await notice.waitFor();
    expect(await notice.innerText()).toContain('nothing');
    const isInFront = await notice.evaluate((each) => {
      const { left, top, width, height } = each.getBoundingClientRect();
      const root = each.getRootNode() as ShadowRoot;
      // At its beginning, in its middle, and at its end.
      return [0.05, 0.5, 0.95].map((part) => {
        const found = root.elementFromPoint(left + part * width, top + height / 2);
        return found === each || each.contains(found);
      });
    });
    expect(isInFront).toEqual([true, true, true]);
  },
);

describe('everyone', () => {
  it('can use it (WCAG 2.2 AA)', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    await goTo(page, 60);
    expect(await violations(page)).toEqual([]);
  });
});
