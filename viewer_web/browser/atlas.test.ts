import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import type { AppElement } from '../src/app/app.js';
import { browser } from './browser.js';
import { edit, rerun } from './live.js';
import { goTo, open, openFile, shown } from './page.js';
import { sample } from './sample.js';

const folder = new URL('../../lessons/failures/', import.meta.url);
const text = (file: string): string => readFileSync(new URL(file, folder), 'utf8');

interface Stated {
  readonly name: string;
  readonly title: string;
  readonly remedy: string;
  readonly step: string;
  readonly there: string;
  readonly pixel: readonly [number, number] | null;
  /** Why its picture has no proof: no text, or one. */
  readonly unproved: readonly string[];
}

const reasons = text('unproved.jsonl')
  .trimEnd()
  .split('\n')
  .map((line) => JSON.parse(line) as { readonly name: string; readonly en: string });

/**
 * The table in the atlas's README has one row for each entry with a scene. `table.mjs` computes it from the traces alone.
 */
const entries = text('README.md')
  .split('\n')
  .filter((line) => line.startsWith('| ['))
  .flatMap((line): Stated[] => {
    const [link = '', , , step = '', there = '', remedy = ''] = line.slice(2, -2).split(' | ');
    const [, title = '', name = ''] = /^\[(.*)\]\((.*)\.json\)$/u.exec(link.trim()) ?? [];
    const file = JSON.parse(text(`${name}.json`)) as {
      scene?: object;
      shows?: { pixel?: [number, number] };
    };
    if (file.scene === undefined) return [];
    const pixel = file.shows?.pixel ?? null;
    const unproved = reasons.filter((reason) => reason.name === name).map(({ en }) => en);
    return [{ name, title, remedy, step: step.trim(), there: there.trim(), pixel, unproved }];
  });

/** The table row of an entry, by its name. */
function entryOf(name: string): Stated {
  const entry = entries.find((each) => each.name === name);
  if (entry === undefined) throw new Error(`no entry ${name}`);
  return entry;
}

async function openGallery(page: Page): Promise<void> {
  await page.locator('vidno-page-header button.atlas').click();
  await page.locator('vidno-gallery dialog[open]').waitFor();
}

async function choose(page: Page, { name, there, remedy }: Stated): Promise<void> {
  await openGallery(page);
  await page.locator(`vidno-gallery [data-entry="${name}"]`).click();
  const note = page.locator('vidno-failure-note').filter({ hasText: remedy });
  await note.locator('.there', { hasText: there }).waitFor();
}

/** The current step and pixel, and the colours of that pixel in this run and in the one beside it. */
function state(page: Page): Promise<{
  readonly step: number;
  readonly length: number;
  readonly pixel: readonly number[] | null;
  readonly colors: readonly (number | null)[];
}> {
  return page.evaluate(() => {
    const app = document.querySelector<AppElement>('vidno-app');
    if (!app) throw new Error('no page');
    const { trace, rival, place, steps } = app.session;
    const { pixel, step } = place;
    const colors = [trace, rival.trace].map((run) => {
      if (run === null || pixel === null) return null;
      const { area } = run.header.scene;
      const { picture } = run.timeline.seek(run.timeline.length).screen;
      return picture.at(pixel[0] - area.x, pixel[1] - area.y);
    });
    return { step, length: steps, pixel, colors };
  });
}

describe('the atlas of failures', () => {
  it('opens each entry at its step, with its answer and remedy, and compares its pixel with the remedy’s', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    expect(entries.length).toBeGreaterThanOrEqual(52);
    expect(entries.filter(({ pixel }) => pixel !== null).length).toBeGreaterThanOrEqual(35);
    for (const entry of sample(entries, 3)) {
      await choose(page, entry);
      const note = page.locator('vidno-failure-note');
      const step = entry.step === '' ? '' : `Step ${Number(entry.step).toLocaleString('en')}: `;
      // Two entries may share their answer and remedy, so the note may still be the previous one.
      const said = async (): Promise<string | undefined> =>
        (await note.locator('.there').textContent())?.trim();
      await expect.poll(said, { message: entry.name }).toBe(`${step}${entry.there}`);
      expect(await note.locator('.remedy').textContent(), entry.name).toContain(entry.remedy);
      await expect
        .poll(
          async () => {
            const { step: at, length, pixel } = await state(page);
            const stated = entry.step === '' ? length : Math.min(Number(entry.step), length);
            return { isThere: at === stated, pixel };
          },
          { message: entry.name },
        )
        .toEqual({ isThere: true, pixel: entry.pixel });
      expect(await note.locator('.unproved p').allTextContents(), entry.name).toEqual(
        entry.unproved,
      );
      if (entry.pixel === null) continue;
      await note.locator('[name=compare]').click();
      await page.locator('vidno-comparison').waitFor();
      const isTold = async (): Promise<boolean> => (await state(page)).colors[1] !== null;
      await expect.poll(isTold, { message: entry.name }).toBe(true);
      const differ = async (): Promise<boolean> => new Set((await state(page)).colors).size === 2;
      await expect.poll(differ, { message: entry.name }).toBe(true);
      await note.locator('[name=compare]').click();
    }
    expect(faults).toEqual([]);
  });

  it('has a picture of each entry, and is filtered by kind', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await openGallery(page);
    const gallery = page.locator('vidno-gallery');
    await expect.poll(() => gallery.locator('svg').count()).toBe(entries.length);
    await gallery.locator('select[name=kind]').selectOption('mistake');
    const names = await gallery
      .locator('[data-entry]')
      .evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset['entry'] ?? ''));
    expect(names.length).toBeGreaterThanOrEqual(11);
    expect(names.filter((name) => !name.startsWith('mistake-'))).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('takes a surface’s remedy with samples of its own', async () => {
    const { page } = await open(browser, '#lang=en');
    await choose(page, entryOf('missed-peak'));
    await page.locator('vidno-failure-note [name=compare]').click();
    await page.locator('vidno-comparison').waitFor();
    const name = await page.evaluate(
      () => document.querySelector<AppElement>('vidno-app')?.session.rival.trace?.header.scene.name,
    );
    expect(name).toBe('The same, sampled where it bends');
  });
});

const hashOf = async (page: Page, part: string): Promise<string> => {
  await page.waitForFunction((text) => location.hash.includes(text), part);
  return new URL(page.url()).hash;
};
const there = (page: Page) => page.locator('vidno-failure-note .there');

describe('the address of an entry', () => {
  const [clipped, peak] = [entryOf('clip-pixel'), entryOf('missed-peak')];

  it('is its name, and leads to it at its step and its pixel', async () => {
    const { page } = await open(browser, '#lang=en');
    await choose(page, clipped);
    const hash = await hashOf(page, 'atlas=clip-pixel');
    expect(hash).not.toContain('scene=');
    const [again, bare] = [
      await open(browser, hash),
      await open(browser, '#lang=en&atlas=clip-pixel'),
    ];
    for (const { page: opened, faults } of [again, bare]) {
      await there(opened).getByText(clipped.there).waitFor();
      const { step, pixel } = await state(opened);
      expect([step, pixel]).toEqual([Number(clipped.step), clipped.pixel]);
      expect(faults).toEqual([]);
    }
  });

  it('may name another step, and the run beside the entry', async () => {
    const { page, faults } = await open(browser, '#lang=ru&atlas=clip-pixel&step=12');
    await there(page).waitFor();
    expect((await state(page)).step).toBe(12);
    await page.locator('vidno-failure-note [name=compare]').click();
    await page.locator('vidno-comparison').waitFor();
    const again = await open(browser, await hashOf(page, 'with='));
    await again.page.locator('vidno-comparison').waitFor();
    expect((await state(again.page)).step).toBe(12);
    expect([...faults, ...again.faults]).toEqual([]);
  });

  it('has the remedy of a surface, which has other samples', async () => {
    const { page } = await open(browser, '#lang=en');
    await choose(page, peak);
    await page.locator('vidno-failure-note [name=compare]').click();
    const again = await open(browser, await hashOf(page, 'with=remedy'));
    await again.page.locator('vidno-comparison').waitFor();
    const name = () =>
      again.page.evaluate(
        () =>
          document.querySelector<AppElement>('vidno-app')?.session.rival.trace?.header.scene.name,
      );
    await expect.poll(name).toBe('The same, sampled where it bends');
    expect(again.faults).toEqual([]);
  });

  it('is restored by Back, from another entry and after a jump', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await choose(page, clipped);
    await hashOf(page, 'atlas=clip-pixel');
    await goTo(page, 3);
    await hashOf(page, 'step=3');
    await choose(page, peak);
    await hashOf(page, 'atlas=missed-peak');
    await page.goBack();
    await there(page).getByText(clipped.there).waitFor();
    await expect.poll(async () => (await state(page)).step).toBe(3);
    await page.goBack();
    await expect.poll(async () => (await state(page)).step).toBe(Number(clipped.step));
    await page.goForward();
    await page.goForward();
    await there(page).getByText(peak.there).waitFor();
    expect(faults).toEqual([]);
  });

  it('becomes that of a scene once the scene is changed, and the note on the step goes away', async () => {
    const { page, faults } = await open(browser, '#lang=en&atlas=clip-pixel');
    await there(page).waitFor();
    await edit(page);
    await rerun(page, () =>
      page.locator('vidno-run-form select[name=kernel]').selectOption('filtered'),
    );
    await there(page).waitFor({ state: 'detached' });
    expect(await page.locator('vidno-failure-note .unproved').count()).toBe(0);
    expect(await hashOf(page, 'scene=')).not.toContain('atlas=');
    await page.locator('vidno-failure-note .remedy', { hasText: clipped.remedy }).waitFor();
    expect(faults).toEqual([]);
  });

  it('that names no entry says so', async () => {
    const { page, faults } = await open(browser, '#lang=en&atlas=no-such-entry');
    const notice = page.locator('vidno-notice [role=alert]');
    await notice.getByText('“no-such-entry”, which this page does not contain').waitFor();
    expect(faults).toEqual([]);
  });
});

describe('a failure file of the reader’s own', () => {
  it('is opened as a file, at its step', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await openFile(page, 'own.json', text('clip-pixel.json'));
    await page
      .locator('vidno-failure-note .there', { hasText: 'the columns: computed 15, exact 14 to 15' })
      .waitFor();
    expect((await shown(page)).step).toBe(74);
    expect(faults).toEqual([]);
  });
});

describe('a file that is not a scene', () => {
  it('lists everything that is wrong with it, with lines and columns, however it is laid out', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const scene = `{
  "window": {"x": 0, "y": 0, "width": 0, "height": 9},
  "polygons": [
    {"colour": "#000000",
     "vertices": [[0, 0, 0], [4, 0], [0, 4, 0]]}
  ]
}`;
    await openFile(page, 'mine.json', scene);
    await page.locator('vidno-notice .faults').waitFor();
    expect(await page.locator('vidno-notice .faults li').allTextContents()).toEqual([
      'line 2, column 39: /window/width: not from 1 to 16384',
      'line 4, column 6: /polygons/0/colour: unknown key',
      'line 5, column 30: /polygons/0/vertices/1: not three coordinates',
    ]);
    await openFile(page, 'broken.json', '{\n  "polygons": [\n    {"vertices" [[0, 0, 0]]}\n  ]\n}');
    await page.locator('vidno-notice .refused', { hasText: 'broken.json' }).waitFor();
    expect(await page.locator('vidno-notice .refused').textContent()).toContain(
      'line 3, column 17: not valid JSON',
    );
    await openFile(page, 'chart.json', '{"format": "vidno-chart/1", "scenes": []}');
    await page.locator('vidno-notice .chart', { hasText: 'is a chart' }).waitFor();
    expect(faults).toEqual([]);
  });

  it('may leave out everything but its vertices', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await openFile(
      page,
      'short.json',
      '{"polygons": [{"vertices": [[1, 2, 0], [9, 2, 0], [1, 8, 0]]}]}',
    );
    await page.locator('vidno-player').waitFor();
    const area = () =>
      page.evaluate(
        () => document.querySelector<AppElement>('vidno-app')?.session.live.editing?.sketch.area,
      );
    await expect.poll(area).toEqual({ x: 1, y: 2, width: 8, height: 6 });
    expect(faults).toEqual([]);
  });
});
