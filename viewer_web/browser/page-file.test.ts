import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { run } from './live.js';
import { openContents, openUrl, whole } from './page.js';

/** A page that the program made from the scene of lesson 5 and the trace of lesson 7. */
const file = join(process.env['VIDNO_STATES'] ?? '', 'page.html');

describe.runIf(existsSync(file))('a page made by the program', () => {
  it('opens its first file, a scene that it runs itself, and lists the others in place of the lessons', async () => {
    const { page, faults } = await openUrl(browser, `${pathToFileURL(file).href}#lang=en`);
    await page.locator('vidno-listing').waitFor();
    const scene = await run(page);
    expect([scene.method, scene.kernel]).toEqual(['warnock', 'double']);
    expect(scene.lines[0]).toContain('"e":"plane"');

    const buttons = page.locator('vidno-lesson-list button');
    expect(await buttons.count()).toBe(2);
    await openContents(page);
    await buttons.last().click();
    const pressed = buttons.last().and(page.locator('[aria-pressed="true"]'));
    await pressed.waitFor({ state: 'attached' });
    await whole(page);
    expect((await run(page)).method).toBe('zbuffer');
    await page.waitForFunction(() => location.hash.includes('trace=2'));
    await openContents(page);
    await buttons.first().click();
    await page.waitForFunction(() => location.hash.includes('scene='));
    expect((await run(page)).lines).toEqual(scene.lines);
    expect(faults).toEqual([]);
  });

  it('opens a trace by its link', async () => {
    const { page } = await openUrl(browser, `${pathToFileURL(file).href}#lang=en&trace=2&step=9`);
    await page.locator('vidno-listing').waitFor();
    expect((await run(page)).method).toBe('zbuffer');
    expect(await page.locator('input[type=number]').inputValue()).toBe('9');
  });
});
