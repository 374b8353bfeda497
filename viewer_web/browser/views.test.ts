import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { violations } from './axe.js';
import { browser, settled } from './browser.js';
import { openScene, scene, square, title, triangle } from './live.js';
import { goTo, open, opened, shown, small, widthOf } from './page.js';
import { openReader, pin, standing } from './reader.js';
import { see } from './views.js';

const views = ['lesson', 'workbench'] as const;
const languages = ['en', 'ru'] as const;

/** Each size with the least side of a square picture, and the least share of the width for its panel. */
const sizes = [
  [1280, 720, 360, 0.4],
  [1440, 900, 450, 0.4],
  [1920, 1080, 540, 0.4],
  [1024, 768, 280, 0.4],
  [390, 844, 351, 0.9], // and 90 % of the width, also on shorter and wider phones
  [390, 664, 351, 0.9],
  [360, 640, 324, 0.9],
  [412, 785, 371, 0.9],
  [640, 360, 280, 0.45], // 1280 x 720, enlarged to 200 %: the controls are beside the picture
] as const;

describe('the picture is the page, with the text beside it', () => {
  it.each(views.flatMap((view) => languages.map((language) => ({ view, language }))))(
    '$view, $language',
    async ({ view, language }) => {
      const hash = `#lang=${language}&lesson=first&view=${view}`;
      const { page, faults } = await openReader(browser, hash);
      await page.locator('vidno-reader').waitFor();
      for (const [width, height, side, part] of sizes) {
        await page.setViewportSize({ width, height });
        await settled(page);
        const seen = await see(page);
        const size = `${width} x ${height}`;
        expect(seen.side, size).toBeGreaterThanOrEqual(side);
        expect(seen.panel, size).toBeGreaterThanOrEqual(part * width);
        expect(await widthOf(page), size).toBe(width);
      }
      expect(faults).toEqual([]);
    },
  );
});

it('has 90 % of the width on a phone without the text, too', async () => {
  const viewport = { width: 390, height: 844 };
  for (const view of views) {
    const { page } = await openReader(browser, `#lang=en&lesson=first&reader=off&view=${view}`, {
      viewport,
    });
    await settled(page);
    expect((await see(page)).side, view).toBeGreaterThanOrEqual(351);
  }
});

describe('the first screen', () => {
  it.each(languages)(
    'has at most 19 controls, and one that stands out, in %s',
    async (language) => {
      const { page } = await openReader(browser, `#lang=${language}`);
      await page.locator('.greeting').waitFor();
      const { controls } = await see(page);
      expect(controls.length).toBeLessThanOrEqual(19);
      // Another lesson is one action away, beside the offer of the tour.
      expect(controls).toContain({ en: 'Lessons', ru: 'Уроки' }[language]);
      expect(await page.locator('vidno-reader .bar select').isVisible()).toBe(true);
      const filled = await page.locator('vidno-transport button').evaluateAll((all) => {
        const colors = all.map((each) => getComputedStyle(each).backgroundColor);
        return all
          .filter((_, i) => colors[i] !== colors.at(-1))
          .map((each) => each.classList.value);
      });
      expect(filled).toEqual(['play']);
    },
  );

  it.each(languages)('shows the whole verdict at every size, in %s', async (language) => {
    const { page } = await openReader(browser, `#lang=${language}&lesson=first`);
    await page.keyboard.press('End');
    await page.locator('.verdict').waitFor();
    for (const [width, height] of sizes) {
      await page.setViewportSize({ width, height });
      await settled(page);
      const hidden = await page
        .locator('vidno-player .sentence')
        .evaluate((sentence) => sentence.scrollHeight - sentence.clientHeight);
      expect(hidden, `${width} x ${height}`).toBe(0);
    }
  });

  it('shows the result of the run, with a verdict, and plays it from the start', async () => {
    const { page, faults } = await openReader(browser, '#lang=en');
    const { step, length } = await shown(page);
    expect(step).toBe(length);
    await page.locator('.welcome', { hasText: 'the nearest is visible' }).waitFor();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('End');
    await expect
      .poll(() => page.locator('.verdict').textContent())
      .toMatch(
        /^Finished: 20 pixels, all as in exact arithmetic; \d+ windows\.$/, // its area has 5 x 4
      );
    await page.getByRole('button', { name: 'Play from the start' }).click();
    await expect.poll(async () => (await shown(page)).step).toBeLessThan(length);
    expect(await page.locator('.verdict').count()).toBe(0);
    expect(faults).toEqual([]);
  });

  it('claims no more than colours where two polygons have the same', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    const alike = scene([triangle, { ...square, color: triangle.color }]);
    await openScene(page, alike);
    await page.locator(title).click();
    await page.keyboard.press('End');
    await expect
      .poll(() => page.locator('.verdict').textContent())
      .toMatch(/^Finished: 64 pixels, all colours as in exact arithmetic; \d+ windows\.$/);
    expect(faults).toEqual([]);
  });

  it('offers a tour of four steps', async () => {
    const { page } = await openReader(browser, '#lang=en');
    await page.locator('.greeting a').click();
    const titles = [];
    for (let i = 0; i < 4; i++) {
      titles.push(await page.locator('vidno-tour h2').textContent());
      const part = await page.locator('vidno-tour .part').boundingBox();
      expect(part?.width).toBeGreaterThan(200);
      if (i === 0) expect(await violations(page)).toEqual([]);
      await page.locator('vidno-tour .next').click();
    }
    expect(titles).toEqual(['The picture', 'The run', 'The procedure', 'The text']);
    expect(await page.locator('vidno-tour').count()).toBe(0);
    await page.reload();
    await page.locator('vidno-listing').waitFor();
    expect(await page.locator('.greeting').count()).toBe(0);
  });

  it('begins the tour at its address', async () => {
    const { page } = await openReader(browser, '#tour');
    await page.locator('vidno-tour h2').waitFor();
  });
});

describe('a verdict', () => {
  it('claims exactness only after a comparison', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    await page.keyboard.press('End');
    await page.locator('.verdict').waitFor();
    // This is the state without a library, which could make an exact picture. The page may still be making one.
    const said = await page.locator('vidno-player').evaluate(async (element) => {
      const player = element as HTMLElementTagNameMap['vidno-player'];
      player.exact = null;
      await player.updateComplete;
      return player.shadowRoot?.querySelector('.verdict')?.textContent;
    });
    expect(said).toContain('not compared with exact arithmetic');
  });
});

describe('the title', () => {
  it('explains each of its words on demand', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const words = page.locator('vidno-run-words');
    for (const [word, meaning] of [
      ['corrected', 'with its errors corrected'],
      ['double', '53 significant bits'],
      ['signs', 'sign of each decision'],
    ] as const) {
      await words.locator('.word', { hasText: word }).click();
      expect(await words.locator('.asked dt').textContent()).toBe(word);
      expect(await words.locator('.asked dd').textContent()).toContain(meaning);
    }
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press('Escape');
    expect(await words.locator('dl').count()).toBe(0);
  });
});

it.each([390, 768])('has its words explained within the window, at %d px', async (width) => {
  const { page } = await openReader(browser, '#lang=ru&lesson=first&reader=off', {
    viewport: { width, height: 844 },
  });
  await page.locator('vidno-run-words button').click();
  const box = await page.locator('vidno-run-words dl').boundingBox();
  if (box === null) throw new Error('no explanations');
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(width);
  expect(await widthOf(page)).toBe(width);
});

describe('the view', () => {
  const view = (page: Page): Promise<string | null> =>
    page.locator('vidno-app').getAttribute('view');

  it('is changed by a button or W, and is part of the link', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    expect(await view(page)).toBe('lesson');
    expect(await page.locator('vidno-side').count()).toBe(0);
    await page.getByRole('button', { name: 'Workbench' }).click();
    await page.locator('vidno-side').waitFor();
    await page.waitForFunction(() => location.hash.includes('view=workbench'));
    await page.reload();
    await page.locator('vidno-side').waitFor();
    expect(await page.locator('vidno-reader').isVisible()).toBe(true);
    await page.keyboard.press('w');
    await page.waitForFunction(() => location.hash.includes('view=lesson'));
  });

  it.each([
    // Links from before views existed.
    ['#lang=en&lesson=first&reader=off', 'workbench', ['warnock', 0]],
    ['#lang=en&lesson=first&at=scanline', 'lesson', ['zbuffer', 33]],
    ['#lang=en&trace=small.zbuffer.signs&step=4&pixel=3,1', 'lesson', ['zbuffer', 4]],
    ['#lang=en&lesson=third&trace=small.warnock.signs&step=7', 'workbench', ['warnock', 7]],
    [
      '#lang=en&lesson=first&trace=small.warnock.signs&step=9&view=present',
      'lesson',
      ['warnock', 9],
    ],
    ['#lang=en&lesson=first&view=workbench.present&step=3', 'workbench', ['warnock', 3]],
  ] as const)('of a link: %s', async (hash, name, at) => {
    const { page, faults } = await openReader(browser, hash);
    await expect.poll(async () => (await standing(page)).slice(0, 2)).toEqual(at);
    expect(await view(page)).toBe(name);
    const presented = await page.locator('.corner').count();
    expect(presented).toBe(hash.includes('present') ? 1 : 0);
    expect(faults).toEqual([]);
  });

  it('has the same keys in both views', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&step=40');
    const side = (): Promise<string | undefined> =>
      page
        .locator('vidno-player')
        .evaluate((player) => (player as HTMLElementTagNameMap['vidno-player']).side);
    for (let i = 0; i < 2; i++) {
      for (const [key, opens] of [
        ['x', 'exact'],
        ['v', 'solid'],
        ['q', 'predict'],
      ] as const) {
        await page.keyboard.press(key);
        await expect.poll(side).toBe(opens);
        await page.keyboard.press(key === 'q' ? 'Escape' : key);
        await expect.poll(side).toBe('state');
      }
      await page.keyboard.press('e');
      await page.locator('vidno-scene-panel').waitFor();
      await page.keyboard.press('e');
      await page.locator('vidno-scene-panel').waitFor({ state: 'detached' });
      await page.keyboard.press('c');
      await page.locator('vidno-cpp').waitFor();
      await page.keyboard.press('c');
      await page.keyboard.press('w');
    }
  });
});

describe('the first page', () => {
  it('is lesson 1 at the end of a Warnock run, without the list that its trace does not record', async () => {
    const { page, faults } = await open(browser, '#lang=en');
    await page.locator('.welcome').waitFor();
    expect(await page.locator('vidno-reader .bar select').inputValue()).toMatch(/^01-/u);
    const { step, length } = await shown(page);
    expect(step).toBe(length);
    await page.keyboard.press('ArrowLeft');
    await page.locator('vidno-warnock').waitFor();
    const part = (name: string): Promise<boolean> =>
      page.locator(`vidno-warnock [data-part=${name}]`).isVisible();
    expect([await part('stack'), await part('active-polygons')]).toEqual([true, false]);
    expect(faults).toEqual([]);
  });
});

describe('the scene', () => {
  it.each([
    ['workbench', 1440, 'reader=off'],
    ['workbench', 1440, ''],
    ['workbench', 1024, 'reader=off'],
    ['lesson', 1440, ''],
  ])('is edited beside listing and state: %s, %i px, %s', async (name, width, rest) => {
    const { page, faults } = await openReader(
      browser,
      `#lang=en&lesson=first&view=${name}&step=60&${rest}`,
      { viewport: { width, height: 900 } },
    );
    const before = await see(page);
    await page.getByRole('button', { name: 'Edit' }).first().click();
    await page.locator('vidno-scene-panel').waitFor();
    const parts = [
      'vidno-listing',
      'vidno-scene-panel',
      ...(name === 'lesson' ? [] : ['vidno-warnock']),
    ];
    for (const part of parts) {
      const box = await page.locator(part).boundingBox();
      expect(box?.height, part).toBeGreaterThan(130);
      expect(box?.width, part).toBeGreaterThan(250);
      expect((box?.y ?? NaN) + (box?.height ?? NaN), part).toBeLessThan(900);
    }
    // The picture keeps its size.
    expect((await see(page)).side).toBe(before.side);
    await page.locator('vidno-scene-panel .close').click();
    await page.locator('vidno-scene-panel').waitFor({ state: 'detached' });
    expect(faults).toEqual([]);
  });

  it('stays while another panel is opened', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first&view=workbench&step=60');
    await page.keyboard.press('e');
    await page.keyboard.press('x');
    await page.locator('vidno-exactness').waitFor();
    expect(await page.locator('vidno-scene-panel').isVisible()).toBe(true);
    expect(await violations(page)).toEqual([]);
  });
});

describe('a divider', () => {
  it('is moved by mouse and by keys, and keeps its position in each view', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    const width = async (part: string): Promise<number> =>
      (await page.locator(part).boundingBox())?.width ?? 0;
    const before = await width('vidno-reader');
    const line = await page.locator('.fold').boundingBox();
    const [x, y] = [(line?.x ?? 0) + 5, (line?.y ?? 0) + 300];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 100, y, { steps: 4 });
    await page.mouse.up();
    await expect.poll(() => width('vidno-reader')).toBeCloseTo(before + 100, -1);

    const picture = await width('section.picture');
    const across = page.locator('vidno-divider.across');
    await across.focus();
    await page.keyboard.press('ArrowLeft');
    await expect.poll(() => width('section.picture')).toBeLessThan(picture - 10);
    expect(Number(await across.getAttribute('aria-valuenow'))).toBeGreaterThan(20);
    const smaller = await width('section.picture');

    await page.reload();
    await page.locator('vidno-listing').waitFor();
    await expect.poll(() => width('vidno-reader')).toBeCloseTo(before + 100, -1);
    await expect.poll(() => width('section.picture')).toBeCloseTo(smaller, 0);
    await page.locator('vidno-divider.across').focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => width('section.picture')).toBeGreaterThan(smaller + 10);
  });

  it('lies between listing, scene and state while a scene is edited beside its lesson', async () => {
    const { page } = await openReader(browser, '#lang=en&lesson=first');
    await page.locator('vidno-listing').waitFor();
    await page.keyboard.press('e');
    await page.keyboard.press('x');
    const height = async (part: string): Promise<number> =>
      (await page.locator(`vidno-player section.${part}`).boundingBox())?.height ?? 0;
    await expect.poll(() => height('scene')).toBeGreaterThan(200);
    for (const [divider, before, after] of [
      ['under', 'listing', 'scene'],
      ['between', 'scene', 'side'],
    ] as const) {
      const [one, other] = [await height(before), await height(after)];
      await page.locator(`vidno-divider.${divider}`).focus();
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('ArrowDown');
      await expect.poll(() => height(before), { message: divider }).toBeGreaterThan(one + 4);
      await expect.poll(() => height(after), { message: divider }).toBeLessThan(other - 4);
    }
  });

  it.each([
    [1024, 768],
    [1280, 720],
    [1440, 900],
  ])('leaves the picture 280 px, wherever it is, at %d x %d', async (width, height) => {
    const viewport = { width, height };
    const { page } = await openReader(browser, '#lang=en&lesson=first', { viewport });
    for (const [part, key] of [
      ['.fold', 'End'],
      ['vidno-divider.across', 'Home'],
    ] as const) {
      const divider = page.locator(part);
      if (!(await divider.isVisible())) continue;
      await divider.focus();
      await page.keyboard.press(key);
      await settled(page);
      expect((await see(page)).side, `${part} ${key}`).toBeGreaterThanOrEqual(280);
    }
  });
});

/** The place on the page of a pixel's centre. */
async function centre(page: Page, x: number, y: number): Promise<readonly [number, number]> {
  return page.locator('vidno-picture > svg').evaluate(
    (stage, [atX, atY]) => {
      const matrix = (stage as SVGSVGElement).getScreenCTM() ?? new DOMMatrix();
      const at = new DOMPoint(atX + 0.5, atY + 0.5).matrixTransform(matrix);
      return [at.x, at.y] as const;
    },
    [x, y] as const,
  );
}

const readout = (page: Page): Promise<string> =>
  page
    .locator('vidno-readout')
    .evaluate((each) => each.shadowRoot?.textContent.replace(/\s+/gu, ' ').trim() ?? '');

describe('axes and readout', () => {
  it('number the columns and rows, and describe the pixel under the pointer', async () => {
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', small);
    await page.keyboard.press('End');
    // The area is 5 x 4 from (2, -1).
    const numbers = (kind: string): Promise<readonly string[]> =>
      page.locator(`vidno-axes .${kind}`).allTextContents();
    expect(await numbers('column')).toEqual(['2', '3', '4', '5', '6']);
    expect(await numbers('row')).toEqual(['−1', '0', '1', '2']);
    expect(await readout(page)).toBe('5 × 4');
    await page.mouse.move(...(await centre(page, 4, 1)));
    await expect.poll(() => readout(page)).toMatch(/^\(4, 1\) .*#[0-9a-f]{6}$/);
    expect(await page.locator('vidno-axes .pointed').allTextContents()).toEqual(['4', '1']);
    await page.locator(title).hover();
    await expect.poll(() => readout(page)).toBe('5 × 4');
  });

  it('write the pixel in the format of the language', async () => {
    const { page } = await open(browser, '#lang=ru');
    await opened(page, 'small.jsonl', small);
    await page.mouse.move(...(await centre(page, 4, 1)));
    await expect.poll(() => readout(page)).toMatch(/^\(4; 1\) /);
  });

  it('of the Z-buffer give the stored depth', async () => {
    const { page } = await openReader(browser, '#lang=en&trace=small.zbuffer.signs');
    await page.keyboard.press('End');
    await settled(page);
    await page.mouse.move(...(await centre(page, 4, 1)));
    const z = await page.locator('vidno-player').evaluate((player) => {
      const { trace, step } = player as HTMLElementTagNameMap['vidno-player'];
      return trace?.timeline.seek(step).screen.z?.at(4 - 2, 1 - -1) ?? null;
    });
    await expect.poll(() => readout(page)).toContain(`z ≈ ${Number(z).toString().slice(0, 4)}`);
  });
});

/** The number of actions for common tasks. A key press, a button press and a choice in a list are one action each. */
describe('common tasks take no more actions than before views existed', () => {
  const at = '#lang=en&lesson=first&step=60';

  it('to the next split: one', async () => {
    const { page } = await openReader(browser, at);
    await page.getByRole('button', { name: 'The next one' }).click();
    expect((await shown(page)).step).toBeGreaterThan(60);
  });

  it('why a pixel has its colour: one', async () => {
    const { page } = await openReader(browser, at);
    await page.mouse.click(...(await centre(page, 4, 1)));
    await page.locator('vidno-history').waitFor();
  });

  it('compare the pixels with exact arithmetic: one choice', async () => {
    const { page } = await openReader(browser, at);
    await page.locator('vidno-picture').hover();
    await page.locator('vidno-layers select').selectOption('difference');
    await page.locator('vidno-layers .difference').waitFor();
  });

  it('change a vertex: two, the editor and the drag', async () => {
    const { page } = await openReader(browser, at);
    await page.getByRole('button', { name: 'Edit' }).click();
    await page.locator('vidno-handles [data-spot]').first().waitFor();
  });

  it('save the figure: one', async () => {
    const { page } = await openReader(browser, at);
    await page.locator('vidno-picture').hover();
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the picture as SVG' }).click(),
    ]);
    expect(download.suggestedFilename()).toMatch(/step-60\.svg$/);
  });

  it.each([
    ['Exact?', 'vidno-exactness'],
    ['3D', 'vidno-solid'],
    ['Predict', 'vidno-question'],
  ])('%s: one', async (name, opened) => {
    const { page } = await openReader(browser, at);
    await page.locator('.sentence').hover();
    await page.getByRole('button', { name, exact: true }).click();
    await page.locator(opened).waitFor();
  });

  it('leave a procedure: one', async () => {
    const { page } = await openReader(browser, at);
    const calls = (): Promise<number> => page.locator('vidno-listing .calls li').count();
    const deep = await calls();
    expect(deep).toBeGreaterThan(1);
    await page.locator('.sentence').hover();
    await page.getByRole('button', { name: 'Out of the procedure, to its result' }).click();
    await expect.poll(calls).toBe(deep - 1);
  });

  it('to any other lesson: one choice', async () => {
    const { page } = await openReader(browser, at);
    await page.locator('vidno-reader .bar select').selectOption('second');
    await page.waitForFunction(() => location.hash.includes('lesson=second'));
  });

  it('to the step that the text mentions, and to a step by its number: one', async () => {
    const { page } = await openReader(browser, at);
    await pin(page, 'first').click();
    await expect.poll(() => standing(page)).toEqual(['warnock', 5, 'first']);
    await goTo(page, 77);
    expect((await shown(page)).step).toBe(77);
  });
});
