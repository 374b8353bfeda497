import { describe, expect, it } from 'vitest';
import { textOf, traceNames } from '../testing/traces.js';
import { eventNames } from '../trace/events.js';
import { linesOf } from './block.js';

describe.each(traceNames)('the lines of %s', (name) => {
  const text = textOf(name);
  const lines = text.trimEnd().split('\n');
  const { header, block, end } = linesOf(new TextEncoder().encode(text));

  it('are found with their events', () => {
    const found = [...block.names].map((number) => eventNames[number]);
    const told = lines.slice(1, -1).map((line) => (JSON.parse(line) as { e: string }).e);
    expect(found).toEqual(told);
    expect(header.trimEnd()).toBe(lines[0]);
    expect(end.trimEnd()).toBe(lines.at(-1));
  });

  it('begin and end where they do', () => {
    const decoder = new TextDecoder();
    const found = [...block.names].map((_, i) =>
      decoder.decode(block.bytes.subarray(block.starts[i], block.starts[i + 1])).trimEnd(),
    );
    expect(found).toEqual(lines.slice(1, -1));
  });
});
