import type { Locator, Page } from 'playwright-core';
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import type { Kind, Part } from '../src/predict/question.js';
import { violations } from './axe.js';
import { browser } from './browser.js';
import { open, opened, sampleTrace, small } from './page.js';
import { verdict } from './predict.js';

const lesson = (name: string): string =>
  gunzipSync(
    readFileSync(new URL(`../../build/lessons/${name}.jsonl.gz`, import.meta.url)),
  ).toString();

/** Runs with questions of some kinds. Where the options lie apart in the picture, they are chosen there. */
interface Course {
  readonly name: string;
  readonly traces: readonly string[];
  readonly inPicture: readonly Kind[];
  readonly inPanel: readonly Kind[];
}

const clipped = [
  sampleTrace('clipped.warnock.signs'),
  lesson('05-polygon-clip.warnock.exact.corrected.signs'),
];
const rows = [lesson('08-show-line.zbuffer.exact.corrected.signs')];
const regions = ['strips', 'wedge', 'wall'].map((name) =>
  sampleTrace(`${name}.weiler-atherton.signs`),
);

const courses: readonly Course[] = [
  {
    name: 'Warnock’s algorithm',
    traces: [small],
    inPicture: ['pop', 'corners'],
    inPanel: ['window', 'inside', 'point'],
  },
  { name: 'PolygonClip', traces: clipped, inPicture: ['clip'], inPanel: [] },
  {
    name: 'planes and depths',
    traces: [small, lesson('02-corner-depths.warnock.double.corrected.signs'), ...clipped, ...rows],
    inPicture: [],
    inPanel: ['plane', 'depth'],
  },
  { name: 'FillPolygon', traces: [small, ...clipped], inPicture: ['fill'], inPanel: [] },
  {
    name: 'VertexSplit',
    traces: [sampleTrace('small.warnock-vertex.signs')],
    inPicture: [],
    inPanel: ['split'],
  },
  {
    name: 'EdgeDepth',
    traces: [
      sampleTrace('edges.warnock-edges.signs'),
      lesson('11-warnock-family.board.warnock-edges.double.corrected.signs'),
    ],
    inPicture: [],
    inPanel: ['edgeDepth'],
  },
  {
    name: 'BackFaces',
    traces: [
      sampleTrace('body.warnock-bodies.signs'),
      lesson('11-warnock-family.bodies.warnock-bodies.double.corrected.signs'),
      sampleTrace('body.warnock-bodies.signs'), // a run finds its back faces once
    ],
    inPicture: [],
    inPanel: ['facing'],
  },
  {
    name: 'the relation test',
    traces: [sampleTrace('small.warnock-full.signs')],
    inPicture: [],
    inPanel: ['relation', 'trial', 'ray'],
  },
  {
    name: 'the sum of angles',
    traces: [sampleTrace('small.warnock-angles.signs')],
    inPicture: [],
    inPanel: ['octants'],
  },
  { name: 'the Z-buffer', traces: rows, inPicture: ['ael', 'pixels'], inPanel: [] },
  {
    name: 'SideEdge',
    traces: [lesson('15-floating-horizon.edges.floating-horizon.double.corrected.signs')],
    inPicture: ['sideEdge'],
    inPanel: [],
  },
  {
    name: 'the floating horizon',
    traces: [sampleTrace('hills.floating-horizon.signs')],
    inPicture: ['flags', 'horizons', 'meeting'],
    inPanel: [],
  },
  {
    name: 'Weiler and Atherton’s algorithm',
    traces: [...regions, sampleTrace('wedge.weiler-atherton.polygons')],
    inPicture: ['entering', 'walk'],
    inPanel: ['piercing', 'sort', 'parted', 'behind', 'stack', 'painted'],
  },
];
const wanted = 3;

interface Asked {
  readonly step: number;
  readonly parts: readonly Pick<Part, 'asks' | 'options' | 'right'>[];
}

/** The question that is open; null if there is none. */
const question = (page: Page): Promise<Asked | null> =>
  page.evaluate(() => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const current = player?.predictor.current;
    if (!current || current.isAnswered) return null;
    const { step, parts } = current.question;
    return {
      step,
      parts: parts.map(({ asks, options, right }) => ({
        asks,
        options: options.map(({ value }) => ({ value })),
        right: [...right],
      })),
    };
  });

/** Asks for this kind alone. */
async function only(page: Page, kind: Kind): Promise<void> {
  await page.evaluate((wanted) => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    for (const each of player?.predictor.offered ?? [])
      player?.predictor.want(each, each === wanted);
  }, kind);
}

/** Clicks the middle of the part of a target that is in the picture. */
async function clickVisible(page: Page, target: Locator): Promise<void> {
  const [all, its] = [
    await page.locator('vidno-targets').boundingBox(),
    await target.boundingBox(),
  ];
  if (all === null || its === null) throw new Error('not shown');
  const middle = (side: 'x' | 'y', size: 'width' | 'height'): number => {
    const from = Math.max(all[side], its[side]);
    const to = Math.min(all[side] + all[size], its[side] + its[size]);
    return (from + to) / 2;
  };
  await page.mouse.click(middle('x', 'width'), middle('y', 'height'));
}

/** Asks the current question once more, with an empty sheet. */
const again = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    const { predictor } = player ?? {};
    if (!predictor?.current) throw new Error('no question');
    const sheet = predictor.current.sheet.map((entry) => ({ ...entry, chosen: [] }));
    predictor.current = { ...predictor.current, sheet };
    predictor.again();
    await player?.updateComplete;
  });

type Way = (page: Page, asked: Asked, inPicture: boolean) => Promise<void>;

const byMouse: Way = async (page, { parts }, inPicture) => {
  for (const [i, { options, right }] of parts.entries()) {
    const field = page.locator(`vidno-question fieldset[data-part="${i}"]`);
    await field.locator('legend').click();
    const row = await field.locator('.entries').count();
    const targets = page.locator('vidno-targets g');
    const canPoint = inPicture && (await targets.count()) === options.length;
    const cells = field.locator('td input');
    if ((await cells.count()) > 0) {
      for (const [cell, value] of right.entries()) await cells.nth(cell).fill(value);
      continue;
    }
    for (const value of right) {
      const at = options.findIndex((option) => option.value === value);
      if (canPoint) await clickVisible(page, targets.nth(at));
      else if (row > 0) await field.locator('.entries button').nth(at).click();
      else await field.locator('label').nth(at).click();
    }
    if (row > 0 && right.length === 0) await field.locator('input').fill('-');
  }
  await page.locator('vidno-question').getByRole('button', { name: 'Check' }).click();
};

const byKeyboard: Way = async (page, { parts }, inPicture) => {
  for (const [i, { options, right }] of parts.entries()) {
    const field = page.locator(`vidno-question fieldset[data-part="${i}"]`);
    const first = field.locator('input').first();
    await first.focus();
    if ((await field.locator('td input').count()) > 0) {
      for (const value of right) {
        await page.keyboard.type(value);
        await page.keyboard.press('Tab');
      }
      continue;
    }
    const isRow = (await field.locator('.entries').count()) > 0;
    const isPictured = (await page.locator('vidno-targets g').count()) === options.length;
    if (isRow) await page.keyboard.type(right.join(' ') || '-');
    else if (inPicture && isPictured) {
      for (const value of right) {
        const target = page
          .locator('vidno-targets g')
          .nth(options.findIndex((each) => each.value === value));
        await target.focus();
        await page.keyboard.press('Enter');
      }
    } else {
      for (const value of right) {
        await page.keyboard.press(String(options.findIndex((each) => each.value === value) + 1));
      }
    }
  }
  await page.locator('vidno-question input:enabled').first().focus();
  await page.keyboard.press('Enter');
};

/** Answers at most this number of questions of a run, each by mouse and then by keyboard; returns how many there were. */
async function answerAll(page: Page, most: number, inPicture: boolean): Promise<number> {
  for (let done = 0; done < most; done++) {
    await page.keyboard.press('q');
    const asked = await question(page);
    if (asked === null) return done;
    await byMouse(page, asked, inPicture);
    expect([asked, (await verdict(page)).at(-1)]).toEqual([asked, 'Right.']);
    await again(page);
    await byKeyboard(page, asked, inPicture);
    expect([asked, (await verdict(page)).at(-1)]).toEqual([asked, 'Right.']);
  }
  return most;
}

describe('three exercises of each kind', () => {
  it.each(courses)('about $name are answered by mouse and by keyboard', async (course) => {
    const { traces, inPicture, inPanel } = course;
    const { page, faults } = await open(browser, '#lang=en');
    for (const kind of [...inPicture, ...inPanel]) {
      let done = 0;
      for (const trace of traces) {
        await opened(page, 'small.jsonl', trace);
        await only(page, kind);
        done += await answerAll(page, wanted - done, inPicture.includes(kind));
        if (done === wanted) break;
      }
      expect([kind, done]).toEqual([kind, wanted]);
    }
    expect(faults).toEqual([]);
  });
});

describe('an exercise', () => {
  it('is a table to be filled in, whose first wrong cell is named with its step', async () => {
    // The square A from (1, -2) to (8, 4) on the area (2, -1) 5 x 4: its edges 3 and 1 are at x = 1 and x = 8, and the last row is 2.
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', sampleTrace('small.zbuffer.signs'));
    await only(page, 'ael');
    await page.keyboard.press('q');
    const form = page.locator('vidno-question');
    const cell = (name: string): Locator => form.getByRole('textbox', { name, exact: true });
    await form.getByRole('textbox', { name: /^Which edges does the list then have/ }).fill('3 1');
    await cell('entry 1, x').fill('1');
    await cell('entry 1, last row').fill('2');
    await cell('entry 2, x').fill('6.5');
    await form.getByRole('button', { name: 'Check' }).click();
    await form.getByText('Answer each part first.').waitFor();
    expect(await cell('entry 2, last row').evaluate((input) => input.matches(':focus'))).toBe(true);
    await cell('entry 2, last row').fill('2');
    await form.getByRole('button', { name: 'Check' }).click();
    expect((await verdict(page)).slice(1)).toEqual(['✓ right', '✗ wrong', 'Not quite.']);
    const wrong = form.locator('fieldset', { has: page.locator('table') });
    expect(await wrong.locator('.first-wrong').textContent()).toBe(
      'First wrong entry: entry 2, x: 8.',
    );
    expect(await wrong.locator('.reasons').textContent()).toContain('8');
    expect(await cell('entry 2, x').getAttribute('aria-invalid')).toBe('true');
    expect(await cell('entry 1, x').getAttribute('aria-invalid')).toBe('false');
    expect(await violations(page)).toEqual([]);
  });

  it('shows hints, takes their cost, and names the first wrong entry with its step', async () => {
    // The triangle (1, -2), (5, 2), (0.5, 3) and the side y = 0: only the first vertex lies above it.
    const { page } = await open(browser, '#lang=en');
    await opened(page, 'small.jsonl', sampleTrace('clipped.warnock.signs'));
    await only(page, 'clip');
    await page.keyboard.press('q');
    const form = page.locator('vidno-question');
    await page.getByRole('checkbox', { name: /3–1/ }).last().click();
    await form.getByRole('button', { name: /^Hint/ }).first().click();
    // The hint adds the other edge of the first vertex, for a third of the point: the triangle has three edges.
    await form.getByText('Hint: 1–2 was wrong and is corrected.').waitFor();
    await form.getByRole('textbox').fill('x 2 3');
    await form.getByRole('button', { name: 'Check' }).click();
    expect(await verdict(page)).toEqual(['✓ right', '✗ wrong', 'Not quite.']);
    expect(await form.locator('.first-wrong').textContent()).toBe('First wrong entry: x.');
    await page.getByText('0.67 of 2 points').waitFor();
    expect(await violations(page)).toEqual([]);
  });
});
