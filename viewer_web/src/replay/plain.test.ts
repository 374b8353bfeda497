import { describe, expect, it } from 'vitest';
import { allSamples } from '../testing/samples.js';
import { headerOf, methodWith, textOf, traceNames } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { parseHeader } from '../trace/header.js';
import { kindsOf } from '../trace/kinds.js';
import type { LineKind } from '../trace/kinds.js';
import { parseLine } from '../trace/parse.js';

function kindOf(line: string): LineKind {
  const { e } = JSON.parse(line) as Event;
  const kind = kindsOf[methodWith(e)].get(e);
  if (kind === undefined) throw new Error(`no event ${e}`);
  return kind;
}

function isPlain(line: string, { plain }: LineKind): boolean {
  plain.lastIndex = 0;
  return plain.test(`${line}\n`);
}

describe('lines in the form that a run writes are plain', () => {
  it.each(traceNames)('%s', (name) => {
    const events = textOf(name).trim().split('\n').slice(1, -1);
    expect(events.filter((line) => !isPlain(line, kindOf(line)))).toEqual([]);
  });

  it.each(allSamples.map((event) => [event.e, JSON.stringify(event)] as const))(
    '%s',
    (_name, line) => {
      expect(isPlain(line, kindOf(line))).toBe(true);
    },
  );
});

/** Possible errors in a line: each of its characters removed or replaced. */
function* mutants(line: string): Generator<string> {
  for (let i = 0; i < line.length; i++) {
    for (const other of ['', '0', '9', '-', '.', 'e', '"', '\\', ',', '[', '}', 'true', '\u0001']) {
      yield line.slice(0, i) + other + line.slice(i + 1);
      yield line.slice(0, i) + other + line.slice(i);
    }
  }
}

describe('a plain line would be accepted when parsed', () => {
  it.each(allSamples.map((event) => [event.e, JSON.stringify(event)] as const))(
    '%s',
    (name, line) => {
      const kind = kindOf(line);
      const header = parseHeader(headerOf(methodWith(name)));
      for (const mutant of mutants(line)) {
        if (!isPlain(mutant, kind)) continue;
        expect(parseLine(mutant, header)).toEqual({
          event: JSON.parse(mutant) as unknown,
        });
      }
    },
  );

  it.each([
    ['a number too large', '{"e":"corners","at":"PW1","z":1e999}'],
    ['a number of many digits', `{"e":"corners","at":"PW1","z":${'9'.repeat(400)}}`],
    ['an edge that is not safe', '{"e":"horizontal","at":"Z9","edge":9007199254740993}'],
    ['a key twice', '{"e":"corners","at":"PW1","z":1,"z":2}'],
    ['an escape', '{"e":"discard","at":"PW3","polygon":"\\u0041"}'],
    ['a space', '{"e":"corners", "at":"PW1","z":1}'],
    ['a text that ends the line', '{"e":"discard","at":"PW3","polygon":"A\n"}'],
  ])('%s is not plain', (_name, line) => {
    const kind = Object.values(kindsOf).flatMap((kinds) => [...kinds.values()]);
    expect(kind.some((each) => isPlain(line, each))).toBe(false);
  });
});
