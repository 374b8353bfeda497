import { describe, expect, it } from 'vitest';
import { textOf, traceNames } from '../testing/traces.js';
import { numberOf } from './events.js';
import type { EventName } from './events.js';
import { Store } from './store.js';
import type { Block } from './store.js';

/** Lines as a block, with the names from parsed lines. */
function blockOf(lines: readonly string[]): Block {
  const texts = lines.map((line) => new TextEncoder().encode(`${line}\n`));
  const ends: number[] = [];
  for (const { length } of texts) ends.push((ends.at(-1) ?? 0) + length);
  const numbers = lines.map((line) => numberOf.get((JSON.parse(line) as { e: EventName }).e) ?? -1);
  return {
    bytes: new Uint8Array(texts.flatMap((text) => [...text])),
    starts: Uint32Array.from([0, ...ends]),
    names: Uint8Array.from(numbers),
  };
}

/** A store that grew by blocks of the given number of lines. */
function storeOf(lines: readonly string[], size: number): Store {
  const store = new Store();
  for (let i = 0; i < lines.length; i += size) store.append(blockOf(lines.slice(i, i + size)));
  return store;
}

const linesOf = (name: string): readonly string[] => textOf(name).trim().split('\n').slice(1, -1);

describe('a store returns what was added', () => {
  it.each(traceNames)('%s, in blocks of any size, forward and backward', (name) => {
    const lines = linesOf(name);
    for (const size of [1, 7, 64, lines.length]) {
      const store = storeOf(lines, size);
      expect(store.length).toBe(lines.length);
      for (const [i, line] of lines.entries()) {
        expect(store.event(i + 1)).toEqual(JSON.parse(line));
        expect(store.line(lines.length - i)).toBe(`${lines.at(-1 - i) ?? ''}\n`);
      }
    }
  });

  it.each(traceNames)('%s, some steps at once', (name) => {
    const lines = linesOf(name);
    for (const size of [1, 7, lines.length]) {
      const store = storeOf(lines, size);
      for (const every of [1, 3, lines.length + 1]) {
        const steps = lines.map((_, i) => i + 1).filter((step) => step % every === 0);
        const found = steps.map((step) => JSON.parse(lines[step - 1] ?? '') as unknown);
        expect(store.eventsAlone(steps)).toEqual(found);
      }
    }
  });

  it('with the numbers of the names', () => {
    const lines = linesOf('small.zbuffer.signs.jsonl');
    const names = [...storeOf(lines, 10).names];
    const clear = numberOf.get('clear');
    expect(names.filter((name) => name === clear)).toHaveLength(1);
    expect(names.indexOf(clear ?? -1)).toBe(lines.findIndex((line) => line.includes('"clear"')));
  });

  it('in any script', () => {
    const line = JSON.stringify({ e: 'discard', at: 'PW3', polygon: 'Ёлка 🎄' });
    const plain = JSON.stringify({ e: 'discard', at: 'PW3', polygon: 'A' });
    const store = storeOf([plain, line, plain], 3);
    expect([1, 2, 3].map((step) => store.event(step))).toEqual(
      [plain, line, plain].map((each) => JSON.parse(each) as unknown),
    );
    expect(store.eventsAlone([2, 3])).toEqual([JSON.parse(line), JSON.parse(plain)]);
  });

  it('with the start of each line among all bytes', () => {
    const lines = linesOf('small.warnock.signs.jsonl').slice(0, 90);
    const sizes = lines.map((line) => Buffer.byteLength(line) + 1);
    for (const size of [1, 7, 90]) {
      const store = storeOf(lines, size);
      let bytes = 0;
      for (const [step, own] of [...sizes, 0].entries()) {
        expect(store.bytesBefore(step)).toBe(bytes);
        expect(store.stepAt(bytes)).toBe(step);
        if (own > 0) expect(store.stepAt(bytes + own - 1)).toBe(step);
        bytes += own;
      }
      const blocks = lines.map((_, i) => Math.min(size * (Math.floor(i / size) + 1), 90));
      expect(lines.map((_, i) => store.endOfBlock(i + 1))).toEqual(blocks);
    }
  });

  it('without depths, wherever they end and whatever else the line contains', () => {
    const depths = Array.from({ length: 2000 }, (_, i) => (i % 3 === 0 ? `${i}/7` : i / 8));
    const span = { e: 'span', at: 'Z14', row: 5, runs: [[0, 2000]] };
    const discard = { e: 'discard', at: 'PW3', polygon: 'Ёлка ,"depths":[1]' };
    const store = storeOf(
      [{ ...span, depths }, { ...span, runs: [], depths: [] }, span, discard].map((each) =>
        JSON.stringify(each),
      ),
      3,
    );
    const found = [1, 2, 3, 4].map((step) => store.eventWithoutDepths(step));
    expect(found).toEqual([span, { ...span, runs: [] }, span, discard]);
    expect(store.eventWithoutDepths(5)).toBeNull();
  });

  it('with nothing before the first and after the last', () => {
    const store = storeOf(linesOf('inside.warnock.signs.jsonl'), 10);
    expect([store.event(0), store.event(store.length + 1)]).toEqual([null, null]);
  });
});
