import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import type { SceneChart } from '../src/chart/scene-format.js';
import type { SurfaceChart } from '../src/chart/surface-format.js';
import { openUrl } from './page.js';
import type { Opened } from './page.js';
import { temporaryFile } from './temporary.js';

/** The page as it was built. */
export const template = readFileSync(
  fileURLToPath(new URL('../dist/chart.html', import.meta.url)),
  'utf8',
);
const textOf = (name: string): string =>
  readFileSync(fileURLToPath(new URL(`../test-data/${name}`, import.meta.url)), 'utf8');

export const sampleText = textOf('chart.json');
export const sample = JSON.parse(sampleText) as SceneChart;
export const surfaceText = textOf('surface-chart.json');
export const surfaceSample = JSON.parse(surfaceText) as SurfaceChart;

/** A page with its data block filled in, as the program writes it. */
function filled(page: string, id: string, json: string): string {
  const tag = `<script type="application/json" id="${id}">`;
  const [before, after, ...others] = page.split(tag);
  if (before === undefined || after === undefined || others.length > 0) {
    throw new Error('The block of data must stand in the page once.');
  }
  const harmless = json.replaceAll('<', '\\u003c');
  return before + tag + harmless + after.slice(after.indexOf('</script>'));
}

/** Opens the page from disk, with a chart in it and the address of the page of traces. */
export async function openChart(
  browser: Browser,
  hash: string,
  json = sampleText,
  options: BrowserContextOptions = {},
  replay: string | null = null,
): Promise<Opened> {
  const file = temporaryFile('chart.html');
  const page = filled(template, 'vidno-chart', json);
  writeFileSync(file, filled(page, 'vidno-replay', JSON.stringify(replay)));
  const opened = await openUrl(browser, `${pathToFileURL(file).href}#${hash}`, options);
  await opened.page.locator('vidno-chart header').waitFor();
  return opened;
}

export const plot = (page: Page): ReturnType<Page['locator']> =>
  page.locator('vidno-plot .canvas svg');

/** The cells of the table of the points, row by row. */
export const rows = (page: Page): Promise<readonly (readonly string[])[]> =>
  page.locator('vidno-points tbody tr').evaluateAll((all) =>
    all.map((row) => [
      row.querySelector('button')?.textContent.trim() ?? '',
      ...[...row.querySelectorAll('td')].map((cell) =>
        [...cell.childNodes]
          .filter(({ nodeType }) => nodeType === Node.TEXT_NODE)
          .map(({ textContent }) => textContent)
          .join('')
          .trim(),
      ),
    ]),
  );

export interface Box {
  readonly text: string;
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The boxes of all texts in the plot on the screen, or in that on paper. */
export const textsIn = (page: Page, plotted = '.canvas'): Promise<readonly Box[]> =>
  page.locator(`vidno-plot ${plotted} svg text`).evaluateAll((all) =>
    all
      .map((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        return { text: text.textContent, left, right, top, bottom };
      })
      .filter(({ left, right }) => right > left),
  );

/** The pairs of texts that cover each other. The box of a text is a little higher than its letters. */
export function overlapping(boxes: readonly Box[]): readonly string[] {
  const slack = 1.5;
  return boxes.flatMap((a, i) =>
    boxes
      .slice(i + 1)
      .filter(
        (b) =>
          a.left < b.right - slack &&
          b.left < a.right - slack &&
          a.top < b.bottom - slack &&
          b.top < a.bottom - slack,
      )
      .map((b) => `${a.text} | ${b.text}`),
  );
}

/** The middles of the symbols of points, on the page. */
export const dots = (
  page: Page,
  of: 'main' | 'added',
): Promise<readonly (readonly [number, number])[]> =>
  page.locator(`vidno-plot .canvas [aria-description="${of} points"] > *`).evaluateAll((all) =>
    all.map((dot) => {
      const { left, right, top, bottom } = dot.getBoundingClientRect();
      return [(left + right) / 2, (top + bottom) / 2] as const;
    }),
  );

const focused = (page: Page): Promise<string> =>
  page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    const input = element as Partial<HTMLInputElement> | null;
    return [element?.localName, input?.name, input?.value].filter(Boolean).join(' ');
  });

/** Moves the focus by Tab to an element with a name, or to an input with a name or value. */
export async function tabTo(page: Page, what: string | RegExp): Promise<void> {
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    if ((await focused(page)).match(what)) return;
  }
  throw new Error(`Tab never comes to ${String(what)}.`);
}
