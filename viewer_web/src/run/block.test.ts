import { describe, expect, it } from 'vitest';
import { textOf, traceNames } from '../testing/traces.js';
import { eventNames, numberOf } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import type { Block } from '../trace/store.js';
import { writtenOf } from './block.js';
import type { Written } from './block.js';

/** A trace in the form of the library: with the starts of all its lines except the first. */
function written(text: string): Written {
  const starts = [...text.matchAll(/\n/g)].map(({ index }) => index + 1).slice(0, -1);
  const name = (start: number): EventName =>
    (JSON.parse(text.slice(start, text.indexOf('\n', start))) as { e: EventName }).e;
  return writtenOf({
    bytes: new TextEncoder().encode(text),
    starts: Uint32Array.from(starts),
    names: Uint8Array.from(starts.slice(0, -1), (start) => numberOf.get(name(start)) ?? 255),
  });
}

/** The lines of a block, cut out of its bytes. */
function linesIn({ bytes, starts }: Block): readonly string[] {
  const decoder = new TextDecoder();
  const line = (start: number, i: number): string =>
    decoder.decode(bytes.subarray(start, starts[i + 1])).trimEnd();
  return [...starts.slice(0, -1)].map(line);
}

describe.each(traceNames)('%s', (name) => {
  const text = textOf(name);
  const lines = text.trimEnd().split('\n');
  const { header, blocks, end } = written(text);

  it('has a first and a last line, with those of the events between them', () => {
    expect(header.trimEnd()).toBe(lines[0]);
    expect(blocks.flatMap(linesIn)).toEqual(lines.slice(1, -1));
    expect(end.trimEnd()).toBe(lines.at(-1));
  });

  it('has each event with the number of its name', () => {
    const found = blocks.flatMap(({ names }) => [...names].map((number) => eventNames[number]));
    const told = lines.slice(1, -1).map((line) => (JSON.parse(line) as { e: string }).e);
    expect(found).toEqual(told);
  });
});

it('a long trace is in many blocks', () => {
  const [header = '', ...rest] = textOf('small.warnock.signs.jsonl').trimEnd().split('\n');
  const body = rest.slice(0, -1);
  const many = Array.from({ length: 40 }, () => body).flat();
  const { blocks } = written([header, ...many, rest.at(-1), ''].join('\n'));
  expect(blocks.length).toBeGreaterThan(3);
  expect(blocks.flatMap(linesIn)).toEqual(many);
});

it('a trace without events has no block', () => {
  const lines = textOf('small.warnock.signs.jsonl').trimEnd().split('\n');
  expect(written(`${lines[0] ?? ''}\n${lines.at(-1) ?? ''}\n`).blocks).toEqual([]);
});
