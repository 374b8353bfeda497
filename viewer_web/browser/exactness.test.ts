import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { edit, openScene, rerun, run, title } from './live.js';
import { goTo, open, opened, sampleTrace } from './page.js';

interface Failure {
  readonly scene: object;
}

/** Opens the page with the scene of an entry of the atlas of failures, run by Warnock's algorithm under double. */
async function failing(name: string, hash = '#lang=en'): Promise<Page> {
  const { page } = await open(browser, hash);
  const file = new URL(`../../lessons/failures/${name}.json`, import.meta.url);
  const { scene } = JSON.parse(readFileSync(file, 'utf8')) as Failure;
  await openScene(page, JSON.stringify(scene));
  return page;
}

/** The steps, from 1, whose events pass a test. */
async function steps(page: Page, passes: (event: { e: string }) => boolean): Promise<number[]> {
  const { lines } = await run(page);
  return lines.flatMap((line, i) => (passes(JSON.parse(line) as { e: string }) ? [i + 1] : []));
}

const wrongOnes = (page: Page): Promise<number[]> => steps(page, ({ e }) => e === 'disagree');
const panel = (page: Page, part = ''): ReturnType<Page['locator']> =>
  page.locator(`vidno-exactness ${part}`);

describe('the right answer', () => {
  it('is found by a check as the panel opens, and the run stays as it is', async () => {
    // `vidno check` finds 167 wrong decisions in this run.
    const { page } = await open(
      browser,
      '#lang=en&reader=off&trace=08-show-line.zbuffer.float.corrected.signs',
    );
    await page.locator(title, { hasText: /./u }).waitFor();
    const { lines } = await run(page);
    const legend = page.locator('vidno-strip-legend');
    await legend.locator('button').click();
    await legend.getByText('if the run was checked: not checked').waitFor();
    await page.locator('vidno-side button.exact').click();
    await panel(page, '.checked').getByText('wrongly at 167 steps').waitFor();
    await legend.getByText('A wrong decision, if the run was checked', { exact: true }).waitFor();

    const goals = page.locator('vidno-travel');
    await goals.locator('select').selectOption('wrong');
    expect(await goals.locator('.count').textContent()).toBe('167');
    await goals.getByLabel('The next one').click();
    await expect.poll(() => goals.locator('.count').textContent()).toBe('1 / 167');
    await panel(page, '.verdict.wrong').getByText('correct for its operands').waitFor();
    expect((await run(page)).lines).toEqual(lines);
    expect(await violations(page)).toEqual([]);
  });

  it.each([
    ['printed', 'But this is not the corrected text'],
    ['corrected', 'Checked: every decision of this run is right.'],
  ])('does not make a text right that is not the corrected one: %s', async (edition, words) => {
    const { page, faults } = await open(
      browser,
      `#lang=en&view=workbench&trace=09-usual-mistakes.warnock.double.${edition}.signs`,
    );
    await page.locator(title, { hasText: /./u }).waitFor();
    await page.keyboard.press('x');
    await panel(page, '.checked').getByText(words).waitFor();
    expect(faults).toEqual([]);
  });

  it('is not taken from the kernel’s name alone in a file of the reader’s own', async () => {
    // A run in doubles that claims to be exact.
    const claimed = sampleTrace('small.zbuffer.signs').replace(
      '"kernel":"double"',
      '"kernel":"exact"',
    );
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'claimed.jsonl', claimed);
    await page.keyboard.press('x');
    await panel(page).getByText('the library runs this scene differently').waitFor();
    expect(await panel(page).getByText('every decision is exact').count()).toBe(0);
  });

  it('comes with a run that was traced with `--check`', async () => {
    const page = await failing('orientation-inverted');
    await edit(page);
    await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    await page.locator('vidno-side button.exact').click();

    // SurroundTest puts the centre of pixel (4, 6) on the wrong side of an edge.
    const [wrong = 0] = await wrongOnes(page);
    for (const step of [wrong - 1, wrong]) {
      await goTo(page, step);
      await expect.poll(() => panel(page, 'dd.words').first().textContent()).toBe('negative');
      expect(await panel(page, 'dd.words').nth(1).textContent()).toBe('positive');
      await panel(page, '.wrong').getByText('This operation rounded').waitFor();
      await panel(page, 'h3').getByText('(4.5, 6.5)').waitFor();
    }
  });

  // The steps of the tables in lessons/failures.
  it.each([
    ['far-vertices-by-ray', 'warnock-full', 9],
    ['vertex-touch', 'weiler-atherton', 28],
  ])('is known for a variant, too: %s', async (name, method, step) => {
    const page = await failing(name);
    await edit(page);
    await rerun(page, () => page.locator('vidno-run-form [name=method]').selectOption(method));
    await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    expect((await wrongOnes(page))[0]).toBe(step + 1); // the decision's own step comes before it
    await goTo(page, step);
    await page.locator('h1').click();
    await page.keyboard.press('x');
    await panel(page, '.wrong').waitFor();
  });
});

describe('the lens', () => {
  it('has the decision of the run in its middle, and is read by keys and mouse', async () => {
    const page = await failing('orientation-inverted');
    await edit(page);
    await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    const [wrong = 0] = await wrongOnes(page);
    await goTo(page, wrong - 1);
    await page.locator('h1').click();
    await page.keyboard.press('x');
    const read = page.locator('vidno-lens p');
    await expect
      .poll(() => read.textContent())
      .toBe('x 0, y 0 ulp: computed negative, exact positive');
    await page.locator('vidno-lens canvas').focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowDown');
    expect(await read.textContent()).toMatch(/^x −1, y \+1 ulp: /u);
    expect((await run(page)).lines.length).toBeGreaterThan(wrong); // the arrow keys select a place and do not step
    await page.locator('vidno-lens canvas').hover({ position: { x: 2, y: 2 } });
    expect(await read.textContent()).toMatch(/^x −24, y −24 ulp: /u);
    expect(await violations(page)).toEqual([]);
  });

  it('agrees with the checked run about every sign', async () => {
    const page = await failing('orientation-zero');
    await edit(page);
    await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    await page.locator('h1').click();
    await page.keyboard.press('x');
    const signs = ['negative', 'zero', 'positive'];
    const { lines } = await run(page);
    const all = await steps(page, ({ e }) => e === 'orient' || e === 'clip_sign');
    // Every tenth sign, and all wrong ones.
    const wrong = new Set((await wrongOnes(page)).map((step) => step - 1));
    for (const step of all.filter((each, i) => i % 10 === 0 || wrong.has(each))) {
      const event = JSON.parse(lines[step - 1] ?? '') as { sign: number; exact: number };
      await goTo(page, step);
      await expect
        .poll(() => page.locator('vidno-lens p').textContent())
        .toBe(
          `x 0, y 0 ulp: computed ${signs[event.sign + 1] ?? ''}, exact ${signs[event.exact + 1] ?? ''}`,
        );
    }
  });

  it('stays until the map of the next sign is drawn', async () => {
    const page = await failing('orientation-inverted');
    const [first = 0, second = 0] = await steps(page, ({ e }) => e === 'orient');
    await goTo(page, first);
    await page.locator('h1').click();
    await page.keyboard.press('x');
    const lens = await page.locator('vidno-lens').elementHandle();
    await goTo(page, second);
    await panel(page, '[aria-busy=false] canvas').waitFor();
    expect(await lens?.evaluate((element) => element.isConnected)).toBe(true);
  });

  it('shows yes and no where depths are compared, in Russian too', async () => {
    const page = await failing('depth-by-an-ulp', '#lang=ru');
    await edit(page);
    await rerun(page, () => page.locator('vidno-run-form [name=check]').check());
    const [wrong = 0] = await wrongOnes(page);
    await goTo(page, wrong);
    await page.locator('h1').click();
    await page.keyboard.press('x');
    await expect
      .poll(() => page.locator('vidno-lens p').textContent())
      .toBe('x 0, y 0 ulp: вычислено нет; точный ответ: да');
    await panel(page, '.hint').getByText('Неверных мест:').waitFor();
  });

  it('does not exist on a grid, or for a decision that is not about a point', async () => {
    const page = await failing('orientation-inverted');
    await edit(page);
    await rerun(page, () => page.locator('vidno-player [name=kernel]').selectOption('grid:8'));
    const [first = 0] = await steps(page, ({ e }) => e === 'orient');
    await goTo(page, first);
    await page.locator('h1').click();
    await page.keyboard.press('x');
    await panel(page, '.hint').getByText('This decision has no map').waitFor();
    await goTo(page, 1);
    await panel(page, '.hint').getByText('No numeric decision').waitFor();
    await page.locator('h1').click();
    await page.keyboard.press('x');
    await page.locator('vidno-warnock').waitFor();
  });
});
