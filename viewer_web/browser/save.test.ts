import { readFileSync } from 'node:fs';
import type { Download, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { goTo, open, opened, small } from './page.js';

async function saved(page: Page, act: () => Promise<unknown>): Promise<Download> {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return download;
}

/** Parses a document in the browser, on a page of its own. */
function read(figure: string): Promise<{ error: boolean; texts: readonly string[] }> {
  return elsewhere((text) => {
    const xml = new DOMParser().parseFromString(text, 'image/svg+xml');
    return {
      error: xml.querySelector('parsererror') !== null,
      texts: [...xml.querySelectorAll('text')].map((each) => each.textContent),
    };
  }, figure);
}

interface Image {
  readonly width: number;
  readonly height: number;
  readonly colors: readonly string[];
}

/** The size of an image, and its colours at positions from 0 to 1. */
function look(png: Buffer, spots: readonly (readonly [number, number])[]): Promise<Image> {
  return elsewhere(
    async ([base64, places]) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes]));
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context?.drawImage(image, 0, 0);
      const colors = places.map(([x, y]) => {
        const dot = context?.getImageData(Math.floor(x * width), Math.floor(y * height), 1, 1);
        return [...(dot?.data ?? [])].join();
      });
      return { width, height, colors };
    },
    [png.toString('base64'), spots] as const,
  );
}

async function elsewhere<T, R>(act: (given: T) => R | Promise<R>, given: T): Promise<R> {
  const page = await browser.newPage();
  try {
    return await page.evaluate(act as never, given);
  } finally {
    await page.close();
  }
}

describe('the picture of a step', () => {
  it('is saved as SVG, well-formed for all names', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const evil = ']]></text>&<\u0007';
    await opened(page, 'small.jsonl', small.replaceAll('"A"', JSON.stringify(evil)));
    await goTo(page, 60);
    const button = page.getByRole('button', { name: 'Save the picture as SVG' });
    const file = await saved(page, () => button.click());
    expect(file.suggestedFilename()).toMatch(
      /^[\p{L}\p{N}-]+\.warnock\.double\.corrected\.step-60\.svg$/u,
    );
    const { error, texts } = await read(readFileSync(await file.path(), 'utf8'));
    expect(error).toBe(false);
    expect(texts).toContain(']]></text>&<\ufffd');
    expect(faults).toEqual([]);
  });

  it('is saved as PNG of 2000 pixels, with the colours of the state', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('End');
    const file = await saved(page, () => page.keyboard.press('Shift+S'));
    expect(file.suggestedFilename()).toMatch(/\.png$/);
    const pixels = [
      [0, 0],
      [1, 2],
      [2, 1],
      [4, 3],
    ] as const;
    const { area, expected } = await page.evaluate((wanted) => {
      const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
      if (!player?.trace) throw new Error('no trace');
      const { header, timeline } = player.trace;
      const { picture } = timeline.seek(player.step).screen;
      const bytes = (pixel = 0): number[] => [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
      return {
        area: header.scene.area,
        expected: wanted.map(([i, j]) => [...bytes(picture.row(j)[i]), 255].join()),
      };
    }, pixels);
    // The area of 5 x 4 pixels has a margin of 7 % of the longer side all around: 5.7 x 4.7 in all.
    expect(area).toEqual({ x: 2, y: -1, width: 5, height: 4 });
    const spots = pixels.map(([i, j]): [number, number] => [
      (0.35 + i + 0.2) / 5.7,
      (0.35 + j + 0.2) / 4.7,
    ]);
    const image = await look(readFileSync(await file.path()), spots);
    // The picture is 720 x 594 on the page, because 593.7 is rounded.
    expect([image.width, image.height]).toEqual([2000, 1650]);
    expect(image.colors).toEqual(expected);
    expect(faults).toEqual([]);
  });
});
