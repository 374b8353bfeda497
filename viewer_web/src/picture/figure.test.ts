import { describe, expect, it } from 'vitest';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import { toColor } from '../replay/screen.js';
import type { Event } from '../trace/events.js';
import type { View } from '../algorithm/view.js';
import { viewOf } from '../algorithm/view.js';
import { figureOf } from './figure.js';
import { lookOf } from './looks.js';

const push: Event = { e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [] };
const fill: Event = { e: 'fill', at: 'W8', rect: [2, 3, 4, 2], color: '#112233' };

async function viewAt(text: string, step: number): Promise<View> {
  return viewOf(await traceOf(text), step, { language: 'en', pixel: null, pointed: null });
}

/** All values of an attribute, in order. */
const written = (figure: string, pattern: RegExp): readonly string[] =>
  [...figure.matchAll(pattern)].map((match) => match.slice(1).join(' '));

/** The coloured rectangles, painted on cells, each cell at most once. */
function painted(figure: string, { header }: View): readonly (readonly string[])[] {
  const { x, y, width, height } = header.scene.area;
  const cells = Array.from({ length: height }, () => new Array<string>(width).fill('none'));
  const [, pixels = ''] = /crispEdges">([^]*?)<\/g>/.exec(figure) ?? [];
  for (const [, color = '', d = ''] of pixels.matchAll(/<path fill="(.*?)" d="(.*?)"\/>/g)) {
    for (const box of d.matchAll(/M(\S+) (\S+)h(\S+)v(\S+)h(\S+)Z/g)) {
      const [left = 0, top = 0, across = 0, down = 0, back = 0] = box.slice(1).map(Number);
      expect(back).toBe(-across);
      for (let j = top - y; j < top - y + down; j++) {
        expect(cells[j]?.slice(left - x, left - x + across)).toEqual(
          new Array<string>(across).fill('none'),
        );
        cells[j]?.fill(color, left - x, left - x + across);
      }
    }
  }
  return cells;
}

describe('the pixels of a figure', () => {
  it('are rectangles, equal runs joined down the rows', async () => {
    const figure = figureOf(await viewAt(textWith(headerOf('warnock'), [push, fill]), 2));
    const background = 'M0 0h8v3h-8ZM0 3h2v2h-2ZM6 3h2v2h-2ZM0 5h8v3h-8Z';
    expect(written(figure, /<path fill="([^"]*)" d="([^"]*)"\/>/g)).toEqual([
      `#ffffff ${background}`,
      '#112233 M2 3h4v2h-4Z',
    ]);
  });

  it.each(['small.warnock.signs.jsonl', 'small.zbuffer.signs.jsonl'])(
    'cover exactly the picture of the step: %s',
    async (name) => {
      const trace = await traceOf(textOf(name));
      const { length } = trace.timeline;
      for (const step of [0, length >> 3, length >> 1, length]) {
        const view = viewOf(trace, step, { language: 'en', pixel: null, pointed: null });
        const { picture } = view.screen;
        const rows = Array.from({ length: picture.height }, (_, j) =>
          Array.from({ length: picture.width }, (_cell, i) => toColor(picture.row(j)[i] ?? 0)),
        );
        expect(painted(figureOf(view), view)).toEqual(rows);
      }
    },
  );
});

describe('a figure', () => {
  it('has the same bytes for the same step, whatever was shown in between', async () => {
    const trace = await traceOf(textOf('small.warnock.signs.jsonl'));
    const at = (step: number): string =>
      figureOf(viewOf(trace, step, { language: 'en', pixel: null, pointed: null }));
    const first = at(200);
    expect(at(201)).not.toBe(first);
    expect(at(200)).toBe(first);
  });

  it('has names as text, with markup escaped and forbidden characters removed', async () => {
    const name = '</text><script>"&\u0000\uffff';
    const text = textWith(headerOf('warnock'), [push]).replaceAll('"A"', JSON.stringify(name));
    const figure = figureOf(await viewAt(text, 1));
    const safe = '&lt;/text&gt;&lt;script&gt;&quot;&amp;\ufffd\ufffd';
    expect(written(figure, />([^<]*)<\/text>/g)).toEqual([safe, safe, 'B', 'B']);
    expect(figure).not.toContain('script>"');
  });

  it('states its step, and what happened there', async () => {
    const figure = figureOf(await viewAt(textWith(headerOf('warnock'), [push]), 1));
    expect(figure).toContain('<title>Two squares · Warnock · Step 1</title>');
    expect(figure).toContain('<desc>The first window, (0, 0) 8 × 8, goes on the stack');
  });

  it('has looks as attributes and no style sheet', async () => {
    const figure = figureOf(await viewAt(textOf('small.warnock.signs.jsonl'), 200));
    expect(figure).not.toMatch(/class=|style=|<style|var\(|url\(|<image|vector-effect/);
  });

  it('has lines of the same width for an area of any size', async () => {
    const widths = async (side: number): Promise<readonly number[]> => {
      const text = textWith(headerOf('warnock'), [push]);
      const wide = text.replace('"width":8,"height":8', `"width":${side},"height":${side}`);
      const figure = figureOf(await viewAt(wide, 0));
      const [scale = 0] = written(figure, /transform="scale\((.*?)\)/g).map(Number);
      const outline = written(figure, /stroke-width="([^"]*)"[^>]*stroke="#112233"/g);
      return outline.map((width) => Math.round(Number(width) * scale * 1000) / 1000);
    };
    expect(await widths(8)).toEqual([1.5]);
    expect(await widths(160)).toEqual([1.5]);
  });
});

describe('the looks of the page', () => {
  it('are found for each class, with the more specific rule taking precedence', () => {
    expect(lookOf('window', 1).get('stroke-width')).toBe('3');
    expect(lookOf('casing window', 1).get('stroke')).toBe('#ffffff');
    expect(lookOf('casing active', 1).get('stroke')).toBe('#10131c');
    expect(lookOf('touched', 1).get('stroke')).toMatch(/^#[0-9a-f]{6}$/);
    expect(lookOf('fresh', 10).get('stroke-dasharray')).toBe('0.5 0.4');
    expect(lookOf('side', 1).get('fill')).toBe('none');
  });
});
