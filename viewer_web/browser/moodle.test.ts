import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Download, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { imported } from '../src/testing/moodle.js';
import { browser, emptyPage } from './browser.js';
import { goTo, open, opened, sampleTrace, small } from './page.js';

const script = fileURLToPath(new URL('../dist/vidno-questions.mjs', import.meta.url));

async function panelOf(text: string, hash: string, panel: string): Promise<Page> {
  const { page } = await open(browser, hash);
  await opened(page, 'run.jsonl', text);
  await page.getByRole('button', { name: panel }).click();
  return page;
}

/** Saves by keyboard alone. */
async function saved(page: Page, button: string): Promise<Download> {
  await page.getByRole('button', { name: button }).focus();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.keyboard.press('Enter'),
  ]);
  return download;
}

/** The output of the script for Node on a trace. */
const asked = (input: string, ...options: readonly string[]): string =>
  execFileSync('node', [script, ...options], { input, encoding: 'utf8', maxBuffer: 2 ** 26 });

/** A browser's reading of a file of questions: elements of its HTML, its text, and the widths of its pictures. */
function seen(page: Page, xml: string, pictures: readonly string[]): Promise<Seen> {
  return page.evaluate(
    async ([text, images]) => {
      const file = new DOMParser().parseFromString(text, 'text/xml');
      const written = [...file.querySelectorAll('questiontext > text, generalfeedback > text')];
      const parts = written.map((each) =>
        new DOMParser().parseFromString(each.textContent, 'text/html'),
      );
      const elements = parts.flatMap((part) => [...part.body.querySelectorAll('*')]);
      const loaded = images.map(async (svg) => {
        const image = new Image();
        image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
        await image.decode();
        return image.width;
      });
      return {
        isWellFormed: file.querySelector('parsererror') === null,
        elements: [...new Set(elements.map(({ localName }) => localName))].sort(),
        text: parts.map(({ body }) => body.textContent).join('\n'),
        widths: await Promise.all(loaded),
      };
    },
    [xml, pictures] as const,
  );
}

interface Seen {
  readonly isWellFormed: boolean;
  readonly elements: readonly string[];
  readonly text: string;
  readonly widths: readonly number[];
}

const utf8 = (bytes: string): string => Buffer.from(bytes, 'latin1').toString();

describe('questions for Moodle', () => {
  it('are saved in the language of the page, as the script for Node writes them', async () => {
    const page = await panelOf(small, '#lang=ru', 'Вопросы');
    const download = await saved(page, 'Вопросы в формате Moodle XML');
    expect(download.suggestedFilename()).toBe(
      'a-square-a-triangle-and-a-slope.warnock.double.corrected.questions.xml',
    );
    const xml = readFileSync(await download.path(), 'utf8');
    expect(xml).toBe(asked(small, '--language', 'ru'));
    expect(xml).not.toBe(asked(small, '--language', 'ru', '--count', '5'));
  });

  it('are nothing but text, tables and pictures, whatever a polygon is called', async () => {
    const page = await emptyPage(browser);
    const name = `]]></text><script>alert('"')</script>{1:SHORTANSWER:=x}&lt;`;
    const xml = asked(small.replaceAll('"A"', JSON.stringify(name)));
    const files = imported(xml).flatMap(({ files: each }) =>
      each.map(({ content }) => utf8(content)),
    );
    const { isWellFormed, elements, text, widths } = await seen(page, xml, files);
    expect(isWellFormed).toBe(true);
    expect(elements).toEqual([
      'div',
      'img',
      'li',
      'ol',
      'p',
      'strong',
      'table',
      'tbody',
      'td',
      'th',
      'tr',
    ]);
    expect(text).toContain(`Polygon ${name}`);
    expect(new Set(widths)).toEqual(new Set([720]));
  });

  it('are absent for a run without questions, and the page says so', async () => {
    const page = await panelOf(sampleTrace('small.zbuffer.windows'), '#lang=en', 'Predict');
    await page.getByRole('button', { name: 'Questions as Moodle XML' }).click();
    await page.getByText('This run has nothing to ask about').waitFor();
    expect(() => asked(sampleTrace('small.zbuffer.windows'))).toThrow('nothing to ask about');
  });

  it('leave the current step as it was', async () => {
    const page = await panelOf(small, '#lang=en', 'Predict');
    await goTo(page, 200);
    const picture = async (): Promise<string> =>
      readFileSync(await (await saved(page, 'Save the picture as SVG')).path(), 'utf8');
    const before = await picture();
    await saved(page, 'Questions as Moodle XML');
    expect(await picture()).toBe(before);
  });
});
