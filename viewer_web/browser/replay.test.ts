import { fileURLToPath, pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { openChart, plot, sample } from './chart.js';
import { compared, names, stepsOf } from './compare.js';
import { scene, square, triangle } from './live.js';
import { openUrl } from './page.js';

const built = pathToFileURL(fileURLToPath(new URL('../dist/index.html', import.meta.url))).href;

/** The first scene of the sample on its own, with a scene to replay. */
const [first] = sample.scenes;
const withScene = JSON.stringify({
  ...sample,
  scenes: [{ ...first, scene: JSON.parse(scene([triangle, square])) as unknown }],
});

describe('a point of the chart', () => {
  it('links to the replay of its run, and to a comparison with the exact one', async () => {
    const { page, faults } = await openChart(browser, 'lang=en', withScene, {}, built);
    const panel = page.locator('vidno-panel');
    const chosen = panel.locator('p').first();
    const replay = panel.getByRole('link', { name: 'Replay this run' });
    await replay.waitFor();
    expect(await violations(page)).toEqual([]);

    // Moves by keyboard along the cost to a run that is not exact.
    await page.locator('vidno-plot .canvas').focus();
    await page.keyboard.press('Home');
    const runOf = /^(Warnock|Z-buffer) (double|float)$/u;
    const named = async (): Promise<string> => ((await chosen.textContent()) ?? '').trim();
    for (let i = 0; i < 40 && !runOf.test(await named()); i++) {
      await page.keyboard.press('ArrowRight');
    }
    const name = runOf.exec(await named());
    expect(name).not.toBeNull();
    const run = `${name?.[1] ?? ''} · corrected · ${name?.[2] ?? ''}`;
    const compare = panel.getByRole('link', { name: 'Compare with the exact run' });
    await compare.waitFor();
    const beside = await openUrl(browser, (await compare.getAttribute('href')) ?? '');
    await compared(beside.page);
    expect(await names(beside.page)).toEqual([run, run.replace(/\w+$/u, 'exact')]);
    await beside.page.keyboard.press('ArrowRight');
    expect((await stepsOf(beside.page))[0]).toBe(1);

    const alone = await openUrl(browser, (await replay.getAttribute('href')) ?? '');
    await alone.page.locator('vidno-run-words button', { hasText: name?.[2] ?? '' }).waitFor();
    expect(alone.faults).toEqual([]);
    expect(faults).toEqual([]);
  });

  it('has no link if the chart has no scenes, or the page of traces is unknown', async () => {
    const bare = await openChart(browser, 'lang=en');
    await plot(bare.page).waitFor();
    expect(await bare.page.locator('vidno-panel a').count()).toBe(0);
    const unknown = await openChart(browser, 'lang=en', withScene, {}, null);
    await plot(unknown.page).waitFor();
    expect(await unknown.page.locator('vidno-panel a').count()).toBe(0);
  });
});
