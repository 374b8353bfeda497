import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import type { AppElement } from '../src/app/app.js';
import { browser } from './browser.js';
import { goTo, isOpen, open, openFile, opened, repeated, shown, small, whole } from './page.js';

describe('a file of the reader’s own', () => {
  it('may be dropped, plain or gzip', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    for (const [name, content] of [
      ['plain.jsonl', Buffer.from(small)],
      ['packed.jsonl.gz', gzipSync(small)],
    ] as const) {
      await drop(page, name, content);
      await isOpen(page, name);
      await whole(page);
      const shownName = await page.locator('.title h2').textContent();
      expect(shownName?.trim()).toBe('A square, a triangle and a slope'); // what it shows, not the file
      expect((await shown(page)).length).toBe(small.trim().split('\n').length - 2);
    }
    expect(faults).toEqual([]);
  });

  it('that is truncated is shown up to the break, with a warning', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'cut.jsonl.gz', gzipSync(small).subarray(0, -1500));
    expect(await page.locator('vidno-notice .shortened').textContent()).toMatch(
      /breaks off after line \d+/,
    );
    expect((await shown(page)).length).toBeGreaterThan(50);
  });

  const header = small.slice(0, small.indexOf('\n'));
  const hostile: readonly (readonly [string, string | Buffer, RegExp])[] = [
    ['text.jsonl', 'hello', /Line 1: not JSON/],
    ['empty.jsonl', '', /empty.jsonl: the file is empty/],
    ['bad.jsonl.gz', Buffer.from([0x1f, 0x8b, 8, 0, 1, 2, 3]), /broken gzip data/],
    ['unknown.jsonl', `${header}\n{"e":"boom","at":"W1"}\n`, /Line 2, \/e: unknown event/],
    ['nan.jsonl', `${header}\n{"e":"corners","at":"PW1","z":NaN}\n`, /Line 2: not JSON/],
    [
      'huge.jsonl',
      `${header}\n{"end":{"events":1e15,"picture":"sha256:${'0'.repeat(64)}"}}\n`,
      /Line 2, \/end\/events: not a count/,
    ],
    [
      'off.jsonl',
      `${header}\n{"e":"fill","at":"W7","rect":[0,0,100000000,1],"color":"#ffffff"}\n`,
      /outside the area/,
    ],
    ['<img src=x onerror=alert(1)>.jsonl', 'x\n', /<img src=x onerror=alert\(1\)>/],
  ];

  it.each(hostile)('%s only gives a message', async (name, content, message) => {
    const { page, faults } = await open(browser, '#lang=en');
    await openFile(page, name, content);
    await page.locator('vidno-notice .failed').waitFor();
    expect(await page.locator('vidno-notice .failed').textContent()).toMatch(message);
    expect(faults).toEqual([]);
  });

  it('is shown up to a late invalid line, with the place and the reason', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const long = repeated(small, /"at":"W3"/, 60_000);
    const late = long.replace(/\n\{"end".*\n/, '\n{"e":"boom","at":"W1"}\n');
    const wrong = late.trim().split('\n').length;
    await openFile(page, 'late.jsonl', late);
    const notice = page.locator('vidno-notice .shortened');
    await notice.waitFor();
    expect(await notice.textContent()).toContain(`Line ${wrong}, /e: unknown event`);
    expect((await shown(page)).length).toBe(wrong - 2);
    await page.keyboard.press('End');
    expect((await shown(page)).step).toBe(wrong - 2);
    expect(faults).toEqual([]);
  });

  it('may come from a Windows editor, and so may a scene', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const utf16 = (text: string): Buffer => Buffer.from(`\ufeff${text}`, 'utf16le');
    await opened(page, 'utf16.jsonl', utf16(small.replaceAll('\n', '\r\n')));
    expect((await shown(page)).length).toBe(small.trim().split('\n').length - 2);
    const { scene } = JSON.parse(small.slice(0, small.indexOf('\n'))) as { scene: object };
    await openFile(page, 'utf16.json.gz', gzipSync(utf16(JSON.stringify(scene, null, 2))));
    await page.locator('.title h2', { hasText: (scene as { name: string }).name }).waitFor();
    expect(await page.locator('vidno-notice :is(.failed, .refused)').count()).toBe(0);
    expect(faults).toEqual([]);
  });

  it('shows markup in names as text', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const evil = '<img src=x onerror=alert(1)>';
    await opened(page, 'evil.jsonl', small.replaceAll('"A"', JSON.stringify(evil)));
    await goTo(page, 1);
    expect((await shown(page)).sentence).toContain(evil);
    expect(await page.locator('img').count()).toBe(0);
    expect(faults).toEqual([]);
  });
});

describe('a mesh', () => {
  // A pyramid: its square base is one face, its sides lack the material of the base.
  const mesh = `mtllib red.mtl
v 0 0 0
v 4 0 0
v 4 0 4
v 0 0 4
v 2 3 2
usemtl red
f 1 2 3 4
usemtl blue
f 1 5 2
f 2 5 3
f 3 5 4
f 4 5 1
l 1 5
`;

  it('becomes a scene, with the colours of the library dropped beside it, and what it lacks', async () => {
    const { page, faults } = await open(browser, '#lang=ru');
    await dropTogether(page, [
      ['red.mtl', Buffer.from('newmtl red\nKd 1 0 0\n')],
      ['pyramid.obj', Buffer.from(mesh)],
    ]);
    await page.locator('.title h2', { hasText: 'pyramid' }).waitFor();
    const { colors, names } = await page.evaluate(() => {
      const scene = document.querySelector<AppElement>('vidno-app')?.session.trace?.header.scene;
      const polygons = scene?.polygons ?? [];
      return { colors: polygons.map(({ color }) => color), names: polygons.map(({ id }) => id) };
    });
    // Faces 0 to 4 in the order of the file; none is edge-on to the camera.
    expect(names).toEqual(['0', '1', '2', '3', '4']);
    expect(colors[0]).toBe('#ff0000');
    const lacks = page.locator('vidno-notice .lacks');
    expect(await lacks.textContent()).toBe('В сцене есть не всё из файла pyramid.obj:');
    expect(await page.locator('vidno-notice li').allTextContents()).toEqual([
      'строка 9: пропущено: цвета: ни в одной библиотеке нет материала «blue»',
      'строка 14: пропущено: линии и точки',
    ]);
    expect(faults).toEqual([]);

    // Another scene lacks nothing.
    await openFile(page, 'solid.off', 'OFF\n3 1 0\n0 0 0\n4 0 0\n0 4 1\n3 0 1 2\n');
    await page.locator('.title h2', { hasText: 'solid' }).waitFor();
    expect(await lacks.count()).toBe(0);
  });

  it('that is refused leaves the page as it is, with the line and the reason', async () => {
    const { page, faults } = await open(browser, '#lang=ru');
    await page.locator('.title h2').getByText(/./u).waitFor();
    const before = await page.locator('.title h2').textContent();
    await openFile(page, 'bad.obj', 'v 0 0 0\nv 1 0 zero\n');
    const notice = page.locator('vidno-notice .unread');
    expect(await notice.textContent()).toBe('bad.obj: строка 2: не число: zero');
    expect(await page.locator('.title h2').textContent()).toBe(before);
    expect(faults).toEqual([]);
  });
});

const drop = (page: Page, name: string, content: Buffer): Promise<void> =>
  dropTogether(page, [[name, content]]);

async function dropTogether(
  page: Page,
  files: readonly (readonly [name: string, content: Buffer])[],
): Promise<void> {
  await page.evaluate(
    (dropped) => {
      const data = new DataTransfer();
      for (const [name, base64] of dropped) {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        data.items.add(new File([bytes], name));
      }
      window.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
    },
    files.map(([name, content]) => [name, content.toString('base64')] as const),
  );
}
