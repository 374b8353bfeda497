import { existsSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { chance } from '../testing/chance.js';
import { allSamples } from '../testing/samples.js';
import { headerOf, linesOf, methodWith, textOf, textWith, traceNames } from '../testing/traces.js';
import { eventsOf, methods } from '../trace/events.js';
import { parseHeader } from '../trace/header.js';
import { QuickRun } from './quick-run.js';
import { read } from './read.js';
import type { News } from './read.js';

const file = new URL('../../../build/release/trace/wasm/vidno.wasm', import.meta.url);
const hasLibrary = existsSync(file);
const library = hasLibrary ? new WebAssembly.Module(readFileSync(file)) : null;

/** All reports about a file, with bytes as text. */
async function newsOf(
  text: string | Uint8Array<ArrayBuffer>,
  by: typeof library,
): Promise<readonly unknown[]> {
  const told: News[] = [];
  for await (const news of read(new Blob([text]), { library: by })) told.push(news);
  return told.map((news) => {
    if (news.is !== 'part') return news;
    const { bytes, starts, names } = news.block;
    // Only the last start is an end.
    return {
      ...news,
      block: {
        text: Buffer.from(bytes).toString('latin1'),
        starts: [...starts],
        names: [...names],
      },
    };
  });
}

async function expectSame(text: string | Uint8Array<ArrayBuffer>): Promise<void> {
  expect(await newsOf(text, library)).toEqual(await newsOf(text, null));
}

/** The number of lines after the first that the library accepts. */
function taken(text: string): number {
  const bytes = new TextEncoder().encode(text);
  const first = bytes.indexOf(10) + 1;
  const header = parseHeader(JSON.parse(text.slice(0, text.indexOf('\n'))));
  const run = library && QuickRun.of(library, bytes.subarray(0, first), header);
  return run?.take(bytes.subarray(first)).names.length ?? -1;
}

/** The text with a character after the first line removed, doubled or replaced. */
function mutant(text: string, below: (n: number) => number): string {
  const first = text.indexOf('\n') + 1;
  const at = first + below(text.length - first);
  const others = ['', '0', '9', '-', '"', ',', 'A', '1.5', '}', '\n', text[at + 1] ?? ''];
  return text.slice(0, at) + (others[below(others.length)] ?? '') + text.slice(at + 1);
}

describe.skipIf(!hasLibrary)('the library reads the same as the page without it', () => {
  it.each(traceNames)('%s, which the library reads to its end', async (name) => {
    const text = textOf(name);
    expect(taken(text)).toBe(text.split('\n').length - 3);
    await expectSame(text);
    await expectSame(new Uint8Array(gzipSync(text)));
    await expectSame(text.slice(0, -200));
  });

  it.each(traceNames)('%s, with any one character wrong', async (name) => {
    const whole = textOf(name).split('\n');
    const text = [...whole.slice(0, 150), ...whole.slice(-2)].join('\n');
    const below = chance(traceNames.indexOf(name) + 1);
    for (let i = 0; i < 6; i++) await expectSame(mutant(text, below));
  });

  it.each(traceNames)('%s, with a line missing or moved', async (name) => {
    const lines = textOf(name).split('\n').slice(0, 200);
    const below = chance(traceNames.indexOf(name) + 1);
    for (let i = 0; i < 6; i++) {
      const [line = ''] = lines.slice(1 + below(lines.length - 1));
      const others = lines.filter((each) => each !== line || below(4) === 0);
      others.splice(1 + below(others.length), 0, ...(i % 2 === 0 ? [line] : []));
      await expectSame(`${others.join('\n')}\n`);
    }
  });

  it.each(methods)('any events of %s, and of others', async (method) => {
    const below = chance(methods.indexOf(method) + 1);
    const own = allSamples.filter(({ e }) => (eventsOf[method] as readonly string[]).includes(e));
    for (let i = 0; i < 12; i++) {
      const from = i % 4 === 0 ? allSamples : own;
      const events = Array.from({ length: 12 }, () => from[below(from.length)]);
      await expectSame(
        textWith(
          headerOf(method),
          events.filter((event) => event !== undefined),
        ),
      );
    }
  });

  it.each([
    ['large letters in a colour', { e: 'color', at: 'PC5', color: '#AABBCC' }],
    ['an event of another method', { e: 'scanline', at: 'Z6', y: 0.5, row: 0 }],
    ['a fraction where there are none', { e: 'corners', at: 'PW1', z: '1/3' }],
    ['a number too large', { e: 'clip_list', at: 'PL7', count: 3_000_000_000 }],
    ['a name that must be escaped', { e: 'discard', at: 'PW3', polygon: '\\"' }],
  ])('%s', async (_name, event) => {
    const method = methodWith('corners');
    await expectSame(linesOf(headerOf(method), event, { end: { events: 1 } }));
  });

  it('except for scenes in which it would be slow', () => {
    const header = headerOf('zbuffer') as { scene: { window: object } };
    const window = { x: 0, y: 0, width: 4097, height: 4096 };
    const wide = { ...header, scene: { ...header.scene, window } };
    expect(taken(linesOf(header, { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' }))).toBe(1);
    expect(taken(linesOf(wide))).toBe(-1);
  });
});
