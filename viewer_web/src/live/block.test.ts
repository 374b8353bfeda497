import { describe, expect, it } from 'vitest';
import { textOf, traceNames } from '../testing/traces.js';
import { eventNames } from '../trace/events.js';
import type { Block } from '../trace/store.js';
import { linesOf } from './block.js';

const blocksOf = (text: string): ReturnType<typeof linesOf> =>
  linesOf(new TextEncoder().encode(text));

/** The lines of a block, as they can be cut out of its bytes. */
function linesIn({ bytes, starts }: Block): readonly string[] {
  const decoder = new TextDecoder();
  const line = (start: number, i: number): string =>
    decoder.decode(bytes.subarray(start, starts[i + 1])).trimEnd();
  return [...starts.slice(0, -1)].map(line);
}

describe.each(traceNames)('the lines of %s', (name) => {
  const text = textOf(name);
  const lines = text.trimEnd().split('\n');
  const { header, blocks, end } = blocksOf(text);

  it('are found with their events', () => {
    const found = blocks.flatMap(({ names }) => [...names].map((number) => eventNames[number]));
    const told = lines.slice(1, -1).map((line) => (JSON.parse(line) as { e: string }).e);
    expect(found).toEqual(told);
    expect(header.trimEnd()).toBe(lines[0]);
    expect(end.trimEnd()).toBe(lines.at(-1));
  });

  it('begin and end where they do', () => {
    expect(blocks.flatMap(linesIn)).toEqual(lines.slice(1, -1));
  });
});

it('a long trace is in many blocks', () => {
  const [header = '', ...rest] = textOf('small.warnock.signs.jsonl').trimEnd().split('\n');
  const body = rest.slice(0, -1);
  const many = Array.from({ length: 40 }, () => body).flat();
  const { blocks } = blocksOf([header, ...many, rest.at(-1), ''].join('\n'));
  expect(blocks.length).toBeGreaterThan(3);
  expect(blocks.flatMap(linesIn)).toEqual(many);
});

it('a trace without events has no block', () => {
  const lines = textOf('small.warnock.signs.jsonl').trimEnd().split('\n');
  expect(blocksOf(`${lines[0] ?? ''}\n${lines.at(-1) ?? ''}\n`).blocks).toEqual([]);
});
