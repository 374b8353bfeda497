import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { edit, editing, openScene, rerun, run, scene, title, triangle } from './live.js';
import { goTo, open, openFile, shown, widthOf } from './page.js';

describe('a scene', () => {
  it('is saved as a file that the page opens again', async () => {
    const { page } = await editing(browser);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save', exact: true }).click(),
    ]);
    expect(download.suggestedFilename()).toBe('two.json');
    const saved = readFileSync(await download.path(), 'utf8');
    const before = await run(page);
    expect(await openScene(page, saved)).toEqual(before);
  });

  it('is part of the link, with its settings and the step', async () => {
    const { page } = await editing(browser);
    await rerun(page, () =>
      page.locator('vidno-run-form select[name=method]').selectOption('zbuffer'),
    );
    await page.locator(title).click();
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
    await page.waitForURL(/scene=.*step=5/u);
    const before = await run(page);
    const again = await open(browser, new URL(page.url()).hash);
    await again.page.locator(title, { hasText: 'Two' }).waitFor();
    expect(await run(again.page)).toEqual(before);
    expect((await shown(again.page)).step).toBe(5);
  });

  it.each([
    ['no JSON', '{"format": "vidno-scene/1", ', /not valid JSON/],
    [
      'markup in a name',
      scene([{ ...triangle, id: '<img src=x onerror=alert(1)>', vertices: [] }]),
      /fewer than three/,
    ],
    ['no number', scene([{ ...triangle, vertices: [['NaN', 0, 0]] }]), /hexadecimal/],
    ['a huge area', scene([triangle], 1e9), /not from 1 to 16384/],
    ['a wrong type', scene([{ ...triangle, color: 7 }]), /not a string/],
  ])('that is invalid only gives a message: %s', async (name, text, message) => {
    const { page, faults } = await open(browser, '#lang=en');
    await openFile(page, `${name}.json`, text);
    await page.locator('vidno-notice .refused').waitFor();
    expect(await page.locator('vidno-notice .refused').textContent()).toMatch(message);
    expect(faults).toEqual([]);
  });

  it('is drawn even if a vertex is almost infinitely far away', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const vertices = [
      [0, 0, 0],
      [1e308, 0, 0],
      [0, 8, 0],
    ];
    await openScene(page, scene([{ ...triangle, vertices }]));
    const box = await page.locator('vidno-picture > svg').getAttribute('viewBox');
    expect(box?.split(' ').map(Number).every(Number.isFinite)).toBe(true);
    expect(faults).toEqual([]);
  });

  it('whose run is too long offers a shorter one, and the scene for the program', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const vertices = (z: number): unknown => [
      [0, z, z],
      [500, 3, z],
      [1, 499, -z],
    ];
    const two = [0, 0.5].map((z, i) => ({ ...triangle, id: `T${i}`, vertices: vertices(z) }));
    await openScene(page, scene(two, 512));
    const notice = page.locator('vidno-notice p').first();
    await expect.poll(() => notice.innerText()).toContain('The run is longer than 1,000,000 steps');
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('vidno-notice').getByRole('button', { name: 'Save the scene' }).click(),
    ]);
    expect(download.suggestedFilename()).toBe('two.json');
    await page.getByRole('button', { name: 'detail “windows”' }).click();
    await notice.waitFor({ state: 'detached' });
    expect(faults).toEqual([]);
  });

  it('that is invalid leaves the previous run, its title and its scene as they were', async () => {
    const { page } = await editing(browser);
    await goTo(page, 5);
    const before = await run(page);
    await openFile(page, 'none.json', scene([triangle, triangle]));
    await page.locator('vidno-notice .refused', { hasText: 'none.json' }).waitFor();
    expect(await page.locator(title).textContent()).not.toContain('none');
    expect(await run(page)).toEqual(before);
    const after = await rerun(page, () =>
      page.locator('vidno-run-form select[name=kernel]').selectOption('exact'),
    );
    expect(after.polygons).toEqual(before.polygons);
    expect((await shown(page)).step).toBe(5);
  });

  it.each(['%%%', 'AAAA', 'x'.repeat(2000)])(
    'in a link that is none only gives a message',
    async (packed) => {
      const { page, faults } = await open(browser, `#lang=en&run=no.such.kernel&scene=${packed}`);
      await page.locator('vidno-notice .failed').waitFor();
      expect(faults).toEqual([]);
    },
  );
});

describe('the form of a scene', () => {
  it('is accessible (WCAG 2.2 AA)', async () => {
    const { page } = await open(browser, '#lang=ru');
    await page.locator(title, { hasText: /./u }).waitFor();
    await edit(page);
    await page.locator('vidno-polygon-form .corners').first().click();
    expect(await violations(page)).toEqual([]);
  });

  it.each([390, 768, 1280, 1920])('is not clipped at %d px', async (width) => {
    const viewport = { width, height: 900 };
    const { page } = await open(browser, '#lang=ru&reader=off', { viewport });
    await page.locator(title, { hasText: /./u }).waitFor();
    await edit(page);
    await page.locator('vidno-polygon-form .corners').first().click();
    expect(await widthOf(page)).toBeLessThanOrEqual(width);
    const cut = await page
      .locator('vidno-scene-panel :is(button, input, select), vidno-scene-panel .message')
      .evaluateAll(
        (parts) =>
          parts.filter((part) => {
            const panel = part.getRootNode() as ShadowRoot;
            const box = panel.host.getBoundingClientRect();
            return part.getBoundingClientRect().right > box.right + 1;
          }).length,
      );
    expect(cut).toBe(0);
  });
});
