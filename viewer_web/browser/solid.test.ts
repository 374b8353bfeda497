import { readFileSync } from 'node:fs';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { headerOf, textWith } from '../src/testing/traces.js';
import { violations } from './axe.js';
import { launch } from './browser.js';
import { looks } from './live.js';
import { goTo, open, opened, sampleTrace, shown, small } from './page.js';
import type { Opened } from './page.js';

let browser: Browser;
let flat: Browser;
beforeAll(async () => {
  browser = await launch('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
  flat = await launch('--disable-3d-apis');
});
afterAll(async () => {
  await Promise.all([browser.close(), flat.close()]);
});

const stage = 'vidno-solid-stage';
const drawing = `${stage} [role=application]`;

/** Opens the page at a step with the 3D view. */
async function solid(
  text = small,
  step = 200,
  { hash = '#lang=en', ...options }: BrowserContextOptions & { hash?: string } = {},
  by = browser,
): Promise<Opened> {
  const { page, faults } = await open(by, hash, options);
  await opened(page, 'small.jsonl', text);
  await goTo(page, step);
  await page.locator('input[type=number]').blur();
  await page.keyboard.press('v');
  await page.locator(drawing).waitFor();
  return { page, faults };
}

/** The faults without the performance warnings of the software renderer. */
const ofPage = (faults: readonly string[]): readonly string[] =>
  faults.filter((fault) => !/GL Driver Message .*Performance/.test(fault));

const caption = (page: Page): Promise<string> => page.locator('vidno-solid .caption').innerText();
const press = (page: Page, name: string): Promise<void> =>
  page.locator(stage).getByRole('button', { name }).click();

/** The canvas pixel at a place in the view, relative to the middle of the box. */
function dotAt(page: Page, x: number, y: number): Promise<readonly number[]> {
  return page.locator(stage).evaluate(
    (host, [u, v]) => {
      const canvas = host.shadowRoot?.querySelector('canvas');
      const box = host.shadowRoot?.querySelector('svg')?.viewBox.baseVal;
      const context = document.createElement('canvas').getContext('2d');
      if (!canvas || !box || !context) return [];
      const scale = canvas.width / box.width;
      context.drawImage(canvas, (box.x - u) * -scale, (box.y - v) * -scale, 1, 1, 0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data];
    },
    [x, y] as const,
  );
}

/** Everything that a turn or a zoom changes. */
const look = (page: Page): Promise<string> =>
  page
    .locator(drawing)
    .evaluate((svg) =>
      [svg, ...svg.querySelectorAll('text')]
        .map((each) => `${each.getAttribute('viewBox') ?? ''} ${each.getAttribute('x') ?? ''}`)
        .join(),
    );

const halves = {
  ...headerOf('warnock'),
  scene: {
    format: 'vidno-scene/1',
    window: { x: 0, y: 0, width: 8, height: 8 },
    background: '#ffffff',
    polygons: [
      {
        id: 'A',
        color: '#c83264',
        vertices: [
          [0, 0, 0.5],
          [4, 0, 0.5],
          [4, 8, 0.5],
          [0, 8, 0.5],
        ],
      },
      {
        id: 'B',
        color: '#112233',
        vertices: [
          [0, 0, 0],
          [4, 0, 0],
          [4, 8, 0],
          [0, 8, 0],
        ],
      },
    ],
  },
};

describe('the scene in 3D', () => {
  it('shows polygons in their colours, the nearest before the others', async () => {
    const text = textWith(halves, [{ e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [] }]);
    const { page } = await solid(text, 0);
    await press(page, 'Front');
    // A is first seen through, 30 % of A over B or the other way round; then 72 % of A is drawn over it. So no channel
    // differs by more than 0.28 x |A - B| from that of A: 51, 4 and 14.
    await expect.poll(async () => (await dotAt(page, -1.5, 0.5))[3]).toBeGreaterThan(200);
    const [red = 0, green = 0, blue = 0] = await dotAt(page, -1.5, 0.5);
    expect(Math.abs(red - 0xc8)).toBeLessThanOrEqual(52);
    expect(Math.abs(green - 0x32)).toBeLessThanOrEqual(6);
    expect(Math.abs(blue - 0x64)).toBeLessThanOrEqual(16);
    // To the right there is only the grid, whose lines do not cross the centres of pixels.
    expect((await dotAt(page, 1.5, 0.5))[3]).toBe(0);
  });

  it('follows the steps, and describes them in words', async () => {
    const at = small.split('\n').findIndex((line) => line.includes('"e":"compare"'));
    const { page, faults } = await solid(small, at);
    await expect
      .poll(() => caption(page))
      .toMatch(/Window .*: the column along z\.[^]*On the plane of .: lb /);
    await goTo(page, 0);
    await expect.poll(() => caption(page)).not.toContain('Window');
    expect(ofPage(faults)).toEqual([]);
  });

  it('shows the scanline of the Z-buffer', async () => {
    const text = sampleTrace('small.zbuffer.signs');
    const { page } = await solid(
      text,
      text.split('\n').findIndex((line) => line.includes('"e":"pixel"')),
    );
    await expect.poll(() => caption(page)).toMatch(/Row .*Active edges: \d[^]*Line [^]*Pixel /);
    expect(await page.locator(`${drawing} .dot.edge`).count()).toBe(2);
  });

  it('is turned, enlarged and moved by keys, which then do not step, and is reset', async () => {
    const { page } = await solid();
    const first = await look(page);
    await page.locator(drawing).focus();
    for (const key of ['ArrowRight', 'ArrowUp', '+', 'Shift+ArrowLeft']) {
      const before = await look(page);
      await page.keyboard.press(key);
      await expect.poll(() => look(page), { message: key }).not.toBe(before);
    }
    expect((await shown(page)).step).toBe(200);
    await page.keyboard.press('0');
    await expect.poll(() => look(page)).toBe(first);
  });

  it('is turned by dragging and enlarged by the wheel', async () => {
    const { page } = await solid();
    const box = await page.locator(drawing).boundingBox();
    if (box === null) throw new Error('no stage');
    const first = await look(page);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 10, { steps: 3 });
    await page.mouse.up();
    const turned = await look(page);
    expect(turned).not.toBe(first);
    await page.mouse.wheel(0, -200);
    await expect.poll(() => look(page)).not.toBe(turned);
  });

  it('points at the thing under the mouse, and lights up pointed things', async () => {
    const { page } = await solid();
    await page.locator(`${stage} .label[data-thing="polygon A"]`).hover();
    await expect.poll(() => looks(page, 'pointed')).toBe(2); // with its casing
  });

  it('is closed by its key, and stays open when another trace is opened', async () => {
    const { page } = await solid();
    await opened(page, 'other.jsonl', small);
    await page.locator(stage).waitFor();
    await page.keyboard.press('v');
    await page.locator('vidno-warnock').waitFor();
    expect(await page.locator(stage).count()).toBe(0);
  });

  it('fits into the panel on any screen', async () => {
    for (const width of [390, 1280, 1920]) {
      const { page } = await solid(small, 200, { viewport: { width, height: 1000 } });
      const panel = await page.locator('vidno-player .side').boundingBox();
      const box = await page.locator(`${stage} canvas`).boundingBox();
      if (panel === null || box === null) throw new Error('no stage');
      expect(box.width).toBeGreaterThan(panel.width - 4);
      expect(box.height).toBeGreaterThan(110);
      expect(box.y + box.height).toBeLessThan(panel.y + panel.height);
    }
  });

  it('is presented without its controls', async () => {
    const { page } = await solid(small, 200, { viewport: { width: 1280, height: 720 } });
    await page.keyboard.press('f');
    await page.locator('.corner').waitFor();
    const height = async (): Promise<number> =>
      (await page.locator(`${stage} canvas`).boundingBox())?.height ?? 0;
    await expect.poll(height).toBeGreaterThan(250);
    expect(await page.locator(`${stage} .views`).isVisible()).toBe(false);
  });

  it('is accessible', async () => {
    const { page, faults } = await solid(small, 200, { hash: '#lang=ru' });
    expect(await violations(page)).toEqual([]);
    expect(ofPage(faults)).toEqual([]);
  });
});

describe('without WebGL', () => {
  it('outlines are drawn, with the reason', async () => {
    const { page, faults } = await solid(small, 200, { hash: '#lang=ru' }, flat);
    expect(await page.locator(`${stage} .missing`).innerText()).toMatch(/нет WebGL/);
    expect(await page.locator(`${drawing} .outline`).count()).toBeGreaterThan(1);
    expect(await violations(page)).toEqual([]);
    expect(ofPage(faults)).toEqual([]);
  });
});

describe('the player alone', () => {
  it('does not contain it', () => {
    const script = readFileSync(new URL('../dist/vidno-player.js', import.meta.url), 'utf8');
    expect(script).not.toContain('WebGL2RenderingContext');
  });
});
