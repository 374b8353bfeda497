import type { Browser, Page } from 'playwright-core';
import { open, openFile, showsAnother } from './page.js';
import type { AppElement } from '../src/app/app.js';
import type { Shape } from '../src/picture/shapes.js';
import type { Opened } from './page.js';

export interface Run {
  readonly method: string;
  readonly edition: string;
  readonly kernel: string;
  readonly polygons: readonly { readonly id: string; readonly vertices: readonly number[][] }[];
  readonly lines: readonly string[];
}

/** All lines of the current run. */
export function run(page: Page): Promise<Run> {
  return page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    if (!player?.trace) throw new Error('no trace');
    const { header, timeline } = player.trace;
    const { method, edition, kernel, scene } = header;
    const polygons = scene.polygons.map(({ id, vertices }) => ({
      id,
      vertices: vertices.map((vertex) => [...vertex]),
    }));
    const line = (_: unknown, i: number): string => timeline.line(i + 1).trimEnd();
    return {
      method,
      edition,
      kernel,
      polygons,
      lines: Array.from({ length: timeline.length }, line),
    };
  });
}

/** Does something and waits for the next run. */
export async function rerun(page: Page, act: () => Promise<unknown>): Promise<Run> {
  await showsAnother(page, act);
  return run(page);
}

/** Opens a scene and waits for its run with every decision. The page may still be opening another one. */
export async function openScene(page: Page, text: string): Promise<Run> {
  const { name } = JSON.parse(text) as { readonly name: string };
  await showsAnother(page, () => openFile(page, 'scene.json', text));
  await page.waitForFunction((wanted) => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.trace?.header.scene.name === wanted;
  }, name);
  return rerun(page, () =>
    page.evaluate(() => {
      const app = document.querySelector<AppElement>('vidno-app');
      app?.session.live.act({ do: 'options', options: { detail: 'signs' } });
    }),
  );
}

/** Opens the scene's panel by its key. */
export async function edit(page: Page): Promise<void> {
  await page.keyboard.press('e');
  await page.locator('vidno-scene-panel').waitFor();
}

/** The place on the page of a point of the scene's plane, in the first picture if there are two. */
export function spotOf(page: Page, x: number, y: number): Promise<{ x: number; y: number }> {
  const picture = page.locator('vidno-picture > svg').first();
  return picture.evaluate(
    (stage, [atX, atY]) => {
      const matrix = (stage as SVGSVGElement).getScreenCTM();
      if (matrix === null) throw new Error('no picture');
      const { x: left, y: top } = new DOMPoint(atX, atY).matrixTransform(matrix);
      return { x: left, y: top };
    },
    [x, y] as const,
  );
}

/** The shapes over the pixels of the current pictures. */
export const shapes = (page: Page): Promise<readonly Shape[]> =>
  page
    .locator('vidno-picture, vidno-region-picture')
    .evaluateAll((all) =>
      all.flatMap((each) => (each as HTMLElementTagNameMap['vidno-picture']).shapes),
    );

/** The number of shapes with a look. */
export const looks = async (page: Page, look: string): Promise<number> =>
  (await shapes(page)).filter((each) => each.look.split(' ').includes(look)).length;

export const handle = (polygon: number, vertex: number): string =>
  `vidno-handles [data-spot="${polygon},${vertex}"]`;

/** The name of the current run. */
export const title = '.title h2';

/** The text of a scene file. */
export const scene = (polygons: readonly unknown[], side = 8): string =>
  JSON.stringify({
    format: 'vidno-scene/1',
    name: 'Two',
    window: { x: 0, y: 0, width: side, height: side },
    background: '#ffffff',
    polygons,
  });
export const triangle = {
  id: 'A',
  color: '#e69f00',
  vertices: [
    [1, 1, 0],
    [6, 1, 0],
    [1, 6, 0.5],
  ],
};
export const square = {
  id: 'B',
  color: '#0072b2',
  vertices: [
    [2, 2, 0.25],
    [7, 2, 0.25],
    [7, 7, 0.25],
    [2, 7, 0.25],
  ],
};

/** A page that has run the two polygons by Warnock's algorithm, with the scene's panel open. */
export async function editing(browser: Browser): Promise<Opened> {
  const found = await open(browser, '#lang=en');
  await openScene(found.page, scene([triangle, square]));
  await edit(found.page);
  return found;
}
