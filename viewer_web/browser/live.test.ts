import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { edit, editing, handle, rerun, run, spotOf, title, triangle } from './live.js';
import { open } from './page.js';

type Noted = Window & { isFollowed: Promise<boolean> };

/** Runs in the page: notes whether the next move of the pointer is followed by another run in the same frame. */
function noteNextMove(): void {
  const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
  const before = player?.trace;
  const isFollowed = new Promise<boolean>((resolve) => {
    const onMove = (): number =>
      requestAnimationFrame(() => {
        resolve(player?.trace !== before);
      });
    window.addEventListener('pointermove', onMove, { capture: true, once: true });
  });
  Object.assign(window, { isFollowed });
}

describe('the library in the page', () => {
  it.each([
    '02-corner-depths.warnock.double.corrected.signs',
    '08-show-line.zbuffer.float.corrected.signs',
    '09-usual-mistakes.zbuffer.double.printed.signs',
    '12-ray-crossings.warnock-full.double.vertex-counted-twice.signs',
  ])('writes what the program wrote: %s', async (trace) => {
    const { page, faults } = await open(browser, `#lang=en&trace=${trace}`);
    await page.locator(title, { hasText: /./u }).waitFor();
    const { lines } = await run(page);
    expect(lines.length).toBeGreaterThan(100);
    await edit(page);
    const detail = page.locator('vidno-run-form select[name=detail]');
    await rerun(page, () => detail.selectOption('windows'));
    const again = await rerun(page, () => detail.selectOption('signs'));
    expect(again.lines).toEqual(lines);
    expect(faults).toEqual([]);
  });

  it('runs another method, kernel, edition and level on request', async () => {
    const { page } = await editing(browser);
    const select = (name: string, value: string) => () =>
      page.locator(`vidno-run-form select[name=${name}]`).selectOption(value);
    expect((await rerun(page, select('method', 'zbuffer'))).method).toBe('zbuffer');
    expect((await rerun(page, select('kernel', 'depth:8'))).kernel).toBe('depth:8');
    const signs = (await run(page)).lines.length;
    expect((await rerun(page, select('detail', 'windows'))).lines.length).toBeLessThan(signs);
    // The kernel depth:8 belongs to the Z-buffer, so Warnock's algorithm gets the default kernel.
    expect((await rerun(page, select('method', 'warnock'))).kernel).toBe('double');
    const checked = await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    await rerun(page, select('detail', 'signs'));
    expect(checked.method).toBe('warnock');
    expect((await run(page)).lines.some((line) => line.includes('"exact":'))).toBe(true);
  });
});

describe('a corner', () => {
  it('is dragged, and the whole drag is undone at once', async () => {
    const { page, faults } = await editing(browser);
    const from = await spotOf(page, 6, 1);
    const to = await spotOf(page, 7.5, 3.25);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await rerun(page, () => page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2));
    const dragged = await rerun(page, () => page.mouse.move(to.x, to.y));
    await page.mouse.up();
    expect(dragged.polygons[0]?.vertices[1]).toEqual([7.5, 3.25, 0]);
    const undone = await rerun(page, () => page.keyboard.press('Control+z'));
    expect(undone.polygons[0]?.vertices).toEqual(triangle.vertices);
    const redone = await rerun(page, () => page.keyboard.press('Control+y'));
    expect(redone.polygons[0]?.vertices[1]).toEqual([7.5, 3.25, 0]);
    expect(faults).toEqual([]);
  });

  it('is followed in the frame of its move while runs are quick, with the same lines as otherwise', async () => {
    const { page, faults } = await editing(browser);
    const from = await spotOf(page, 6, 1);
    const places = await Promise.all([6.5, 7, 7.5].map((x) => spotOf(page, x, 2)));
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    // The first runs, which show that these are quick, are made elsewhere.
    for (let i = 1, isFollowed = false; !isFollowed; i++) {
      expect(i).toBeLessThan(100);
      await page.evaluate(noteNextMove);
      const { x, y } = places[i % places.length] ?? from;
      await rerun(page, () => page.mouse.move(x, y));
      isFollowed = await page.evaluate(() => (window as unknown as Noted).isFollowed);
    }
    await page.mouse.up();
    const { lines } = await run(page);
    expect(lines.length).toBeGreaterThan(100);
    const detail = page.locator('vidno-run-form select[name=detail]');
    await rerun(page, () => detail.selectOption('windows'));
    expect((await rerun(page, () => detail.selectOption('signs'))).lines).toEqual(lines);
    expect(faults).toEqual([]);
  });

  it('is moved, lifted, added and removed by keys', async () => {
    const { page } = await editing(browser);
    const press = (key: string) => () => page.keyboard.press(key);
    await page.locator(handle(0, 0)).focus();
    expect((await rerun(page, press('ArrowRight'))).polygons[0]?.vertices[0]).toEqual([1.25, 1, 0]);
    expect((await rerun(page, press('Shift+ArrowDown'))).polygons[0]?.vertices[0]?.[1]).toBe(2);
    expect((await rerun(page, press('PageUp'))).polygons[0]?.vertices[0]?.[2]).toBe(0.0625);
    expect((await rerun(page, press('+'))).polygons[0]?.vertices).toHaveLength(4);
    expect((await rerun(page, press('Delete'))).polygons[0]?.vertices).toHaveLength(3);
  });

  it('is typed', async () => {
    const { page } = await editing(browser);
    await page.getByRole('button', { name: 'vertices of A' }).click();
    const x = page.getByRole('spinbutton', { name: 'x of vertex 2' });
    const typed = await rerun(page, async () => {
      await x.fill('5.125');
      await x.press('Enter');
    });
    expect(typed.polygons[0]?.vertices[1]).toEqual([5.125, 1, 0]);
  });

  it('that makes a polygon concave has it cut into two parts of one face', async () => {
    const { page } = await editing(browser);
    await page.locator(handle(1, 0)).focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+ArrowRight');
    for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+ArrowDown');
    await page.waitForFunction(() => {
      const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
      return player?.trace?.header.scene.polygons.length === 3;
    });
    expect((await run(page)).polygons.map(({ id }) => id)).toEqual(['A', 'B.1', 'B.2']);
  });

  it('that makes a polygon invalid is refused, and the previous run stays', async () => {
    const { page } = await editing(browser);
    const before = await run(page);
    await page.locator(handle(1, 0)).focus();
    for (let i = 0; i < 6; i++) await page.keyboard.press('Shift+ArrowRight');
    await page.locator('.message.refused').waitFor();
    expect(await page.locator('.message').textContent()).toContain('B: not convex');
    const after = await run(page);
    expect(after.polygons[1]?.vertices).not.toEqual([[6, 6, 0.25]]);
    expect(before.polygons[0]).toEqual(after.polygons[0]);
    await page.locator('vidno-languages [lang=ru]').click();
    expect(await page.locator('.message').textContent()).toContain('B: не выпуклый');
  });
});

describe('a polygon', () => {
  it('is drawn by mouse', async () => {
    const { page } = await editing(browser);
    await page.keyboard.press('n');
    for (const [x, y] of [
      [3, 1],
      [7, 1],
      [7, 5],
    ] as const) {
      const spot = await spotOf(page, x, y);
      await page.mouse.click(spot.x, spot.y);
    }
    const drawn = await rerun(page, async () => {
      const { x, y } = await spotOf(page, 3, 1);
      await page.mouse.click(x, y);
    });
    expect(drawn.polygons[2]).toEqual({
      id: 'C',
      vertices: [
        [3, 1, 0.75], // in front of A, whose nearest vertex has depth 0.5
        [7, 1, 0.75],
        [7, 5, 0.75],
      ],
    });
  });

  it('is drawn by keyboard', async () => {
    const { page } = await editing(browser);
    await page.keyboard.press('n');
    await page.locator('vidno-handles .pen').waitFor();
    await page.keyboard.press('Space'); // in the middle, (4, 4)
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('Space');
    await page.keyboard.press('Shift+ArrowDown');
    await page.keyboard.press('Space');
    const drawn = await rerun(page, () => page.keyboard.press('Enter'));
    expect(drawn.polygons[2]?.vertices).toEqual([
      [4, 4, 0.75],
      [5, 4, 0.75],
      [5, 5, 0.75],
    ]);
  });

  it('is reordered, renamed and removed', async () => {
    const { page } = await editing(browser);
    const ids = async (name: string): Promise<readonly string[]> => {
      const { polygons } = await rerun(page, () => page.getByRole('button', { name }).click());
      return polygons.map(({ id }) => id);
    };
    expect(await ids('B earlier')).toEqual(['B', 'A']);
    expect(await ids('Remove B')).toEqual(['A']);
    const name = page.getByRole('textbox', { name: 'name of A' });
    const renamed = await rerun(page, async () => {
      await name.fill('<b>Z</b>');
      await name.press('Enter');
    });
    expect(renamed.polygons[0]?.id).toBe('<b>Z</b>');
  });
});
