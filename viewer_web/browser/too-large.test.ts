import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { open, opened } from './page.js';

const corners = [
  [0, 0, 0],
  [8, 0, 0],
  [0, 8, 0],
];

/** A run of `count` polygons over a square area of this side. Only the first polygon is begun. */
function run(count: number, side: number): string {
  const polygons = Array.from({ length: count }, (_, i) => ({
    id: `P${i}`,
    color: '#112233',
    vertices: corners,
  }));
  const scene = {
    format: 'vidno-scene/1',
    name: 'Too large',
    window: { x: 0, y: 0, width: side, height: side },
    background: '#ffffff',
    polygons,
  };
  const how = { method: 'zbuffer', edition: 'corrected', kernel: 'double', detail: 'polygons' };
  const lines = [
    { format: 'vidno-trace/1', ...how, scene },
    { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
    { e: 'polygon', at: 'Z2', polygon: 'P0', color: '#112233' },
    { end: { events: 2, picture: `sha256:${'0'.repeat(64)}` } },
  ];
  return lines.map((line) => `${JSON.stringify(line)}\n`).join('');
}

describe('a state that is too large to show', () => {
  it('is refused in words, and the rest of the run is shown', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const depths = page.locator('vidno-depths');
    const refusal = page.locator('vidno-player .news');
    await opened(page, 'less.jsonl', run(3000, 8));
    expect(await page.locator('vidno-side button.solid').count()).toBe(1);
    await opened(page, 'wide.jsonl', run(1, 4097));
    await page.keyboard.press('End');
    await expect
      .poll(() => depths.locator('p').innerText())
      .toContain('at most 4096 × 4096 pixels');
    await page.locator('vidno-languages [lang=ru]').click();
    await expect
      .poll(() => depths.locator('p').innerText())
      .toContain('не больше 4096 × 4096 пикселей');
    await page.keyboard.press('v');
    await page.locator('vidno-solid').waitFor();

    // The 3D view is open, and the state replaces it.
    await opened(page, 'many.jsonl', run(3001, 8));
    await page.keyboard.press('End');
    expect(await page.locator('vidno-solid').count()).toBe(0);
    expect(await depths.locator('table').count()).toBe(1);
    expect(await page.locator('vidno-side button.state').getAttribute('aria-pressed')).toBe('true');
    await page.keyboard.press('v');
    await expect.poll(() => refusal.innerText()).toContain('не более чем для 3000 многоугольников');
    await page.locator('vidno-languages [lang=en]').click();
    await page.keyboard.press('v');
    await expect.poll(() => refusal.innerText()).toContain('at most 3000 polygons');
    expect(faults.filter((fault) => !fault.includes('WebGL'))).toEqual([]);
  });
});
