import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { browser, emptyPage } from './browser.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const program = process.env['VIDNO_PROGRAM'] ?? join(root, 'build/release/trace/vidno');
const folder = mkdtempSync(join(tmpdir(), 'vidno-film-'));
afterAll(() => {
  rmSync(folder, { recursive: true });
});

/** The frames of a film of three steps, two a second. */
function film(): string {
  const run = join(folder, 'run.jsonl');
  const file = join(folder, 'film.svg');
  const scene = join(root, 'lessons/01-four-relations/scene.json');
  execFileSync(program, ['trace', scene, '-o', run]);
  execFileSync(program, ['figure', run, '--steps', '4..6', '--film', '--rate', '2', '-o', file]);
  return pathToFileURL(file).href;
}

describe('a film of a run', () => {
  it('plays without scripts, and shows each of its steps in turn', async () => {
    const page = await emptyPage(browser, { javaScriptEnabled: false });
    await page.goto(film());
    const shownAt = (seconds: number): Promise<readonly number[]> =>
      page.evaluate((time) => {
        const svg = document.querySelector('svg');
        if (svg === null) return [];
        svg.pauseAnimations();
        svg.setCurrentTime(time);
        return [...svg.children]
          .filter((each) => each.tagName === 'g')
          .flatMap((each, i) => (getComputedStyle(each).visibility === 'visible' ? [i] : []));
      }, seconds);
    expect(await shownAt(0.25)).toEqual([0]);
    expect(await shownAt(0.75)).toEqual([1]);
    expect(await shownAt(1.25)).toEqual([2]);
    expect(await shownAt(1.75)).toEqual([0]);
  });
});
