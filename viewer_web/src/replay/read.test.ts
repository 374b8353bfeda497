import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { samples } from '../testing/samples.js';
import {
  headerOf,
  keptOf,
  linesOf,
  textOf,
  textWith,
  traceNames,
  traceOf,
} from '../testing/traces.js';
import { read } from './open.js';
import { Unreadable } from './trace.js';

const header = headerOf('warnock');
const push = samples.push[0];
const whole = textWith(header, push ? [push] : []);
const bytes = (text: string): Uint8Array<ArrayBuffer> => new Uint8Array(Buffer.from(text));
const zipped = (text: string): Uint8Array<ArrayBuffer> => new Uint8Array(gzipSync(text));

describe('a whole trace', () => {
  it.each(traceNames)('%s is read, plain and gzip', async (name) => {
    const text = textOf(name);
    for (const file of [text, zipped(text)]) {
      const trace = await traceOf(file);
      expect(trace.shortened).toBeNull();
      expect(trace.timeline.length).toBe(text.split('\n').length - 3);
    }
  });

  it('may lack the last newline', async () => {
    expect((await traceOf(whole.trimEnd())).shortened).toBeNull();
  });
});

describe('a truncated trace is read up to the break', () => {
  const text = textOf('small.warnock.signs.jsonl');

  it('between lines', async () => {
    const trace = await traceOf(text.split('\n').slice(0, 11).join('\n') + '\n');
    expect(trace.shortened).toEqual({ why: 'cut', line: 11 });
    expect(trace.timeline.length).toBe(10);
  });

  it('within a line', async () => {
    const trace = await traceOf(text.slice(0, 5000));
    expect(trace.shortened?.why).toBe('cut');
    expect(trace.timeline.length).toBe(text.slice(0, 5000).split('\n').length - 2);
  });

  it('within the gzip stream', async () => {
    const trace = await traceOf(zipped(text).slice(0, -2000));
    expect(trace.shortened?.why).toBe('cut');
    expect(trace.timeline.length).toBeGreaterThan(100);
  });

  it('at the limit of the page', async () => {
    const lines = text.split('\n');
    const long = [...lines.slice(0, -2), ...lines.slice(1, -2)].join('\n');
    const { shortened, timeline } = await traceOf(long, 150_000);
    expect(long.length).toBeGreaterThan(150_000);
    expect(timeline.length).toBeGreaterThan(100);
    expect(shortened).toEqual({ why: 'limit', line: timeline.length + 1 });
  });

  it('at a line that is too long to hold', async () => {
    const [first = '', ...lines] = text.split('\n');
    const blown = [first, ...lines.slice(0, 9), 'x'.repeat(2 ** 18)].join('\n');
    const found = read(new Blob([zipped(blown)]), Infinity, 2 ** 17);
    for await (const trace of found) if (trace.complete) expect(trace.shortened?.why).toBe('limit');
    const headless = read(new Blob([zipped('x'.repeat(3000))]), Infinity, 1000);
    await expect(headless.next()).rejects.toThrow('a line of more than 64 MiB');
  });

  it('by the run itself', async () => {
    const partial = whole.replace(/"picture":"[^"]*"/, '"partial":true');
    expect((await traceOf(partial)).shortened?.why).toBe('partial');
  });
});

const broken: readonly (readonly [string, string | Uint8Array<ArrayBuffer>, number, string])[] = [
  ['nothing', '', 1, 'empty, not a trace'],
  ['an empty line', '\n', 1, 'not JSON'],
  ['no JSON', 'hello\n', 1, 'not JSON'],
  ['no JSON, without a newline', 'hello', 1, 'not JSON'],
  ['a picture', bytes('\u0089PNG\r\n\u001a\n'), 1, 'not JSON'],
  ['not UTF-8', new Uint8Array([0x7b, 0xff, 0xfe, 0x0a]), 1, 'not JSON'],
  ['bad gzip', new Uint8Array([0x1f, 0x8b, 1, 2, 3, 4]), 1, 'broken gzip data'],
  ['a list', '[]\n', 1, 'not an object'],
  ['another format', linesOf({ ...header, format: 'vidno-scene/1' }), 1, 'not "vidno-trace/1"'],
  [
    'a later format',
    linesOf({ ...header, format: 'vidno-trace/2' }),
    1,
    'not "vidno-trace/1" but "vidno-trace/2": a newer vidno reads this file',
  ],
  [
    'an earlier format',
    linesOf({ ...header, format: 'vidno-trace/0' }),
    1,
    'not "vidno-trace/1" but "vidno-trace/0": an older vidno reads this file',
  ],
  [
    'a kernel that there is not',
    linesOf({ ...header, kernel: 'bits:25' }),
    1,
    'not one of float, double, bits:P (4 <= P <= 24), depth:B (2 <= B <= 32), filtered, grid:K (1 <= K <= 20), exact',
  ],
  ['an unknown key in the header', linesOf({ ...header, author: 1 }), 1, 'unknown key author'],
  ['no scene', linesOf({ ...header, scene: undefined }), 1, 'no key scene'],
  ['no event', linesOf(header, { e: 'explode', at: 'W1' }), 2, 'unknown event'],
  ['a prototype for an event', linesOf(header, { e: '__proto__', at: 'W1' }), 2, 'unknown event'],
  [
    'an event of the other method',
    linesOf(header, samples.scanline[0]),
    2,
    'an event of another method',
  ],
  [
    'an event of a higher level',
    linesOf(headerOf('warnock', 'windows'), samples.corners[0]),
    2,
    "an event above the trace's level of detail",
  ],
  ['an unknown key', linesOf(header, { ...push, extra: 1 }), 2, 'unknown key extra'],
  ['a missing key', linesOf(header, { e: 'pop', at: 'W5' }), 2, 'no key window'],
  ['another label', linesOf(header, { ...push, at: 'W4' }), 2, 'not a line of this event'],
  ['NaN', `${linesOf(header)}{"e":"corners","at":"PW1","z":NaN}\n`, 2, 'not JSON'],
  [
    'a number too large',
    `${linesOf(header)}{"e":"corners","at":"PW1","z":1e999}\n`,
    2,
    'the number is beyond the range of doubles',
  ],
  [
    'a text for a number',
    linesOf(header, { e: 'corners', at: 'PW1', z: '<b>' }),
    2,
    'not a number of this kernel',
  ],
  ['a short window', linesOf(header, { ...push, window: [0, 0, 8] }), 2, 'not a list of 4'],
  ['a line after the last', whole + linesOf(push), 4, 'text after the last line'],
  [
    'a wrong count of events',
    whole.replace('"events":1', '"events":2'),
    3,
    'not the number of events read',
  ],
  ['an area too large', whole.replace('"width":8', '"width":16385'), 1, 'not from 1 to 16384'],
  ['an id twice', whole.replace('"id":"B"', '"id":"A"'), 1, 'the id occurs twice'],
  ['a bad colour', whole.replace('#112233', 'url(x)'), 1, 'not a colour of the form "#rrggbb"'],
];

describe('a wrong line leaves the run before it', () => {
  const lines = textOf('small.warnock.signs.jsonl').trimEnd().split('\n');
  const wrong = 201;

  it.each<[string, string, string, string]>([
    ['no JSON', '{"e":', '', 'not JSON'],
    ['no event', '{"e":"boom","at":"W1"}', '/e', 'unknown event'],
    ['a wrong value', '{"e":"push","at":"W3","window":[0,0,8,"x"]}', '/window/3', 'not a number'],
    [
      'what cannot happen',
      '{"e":"clear","at":"Z1","color":"#ffffff","z":0}',
      '',
      'an event of another method',
    ],
  ])('%s', async (_what, line, path, reason) => {
    const text = [...lines.slice(0, wrong - 1), line, ...lines.slice(wrong)].join('\n');
    const { shortened, complete, timeline } = await keptOf(`${text}\n`);
    expect(complete).toBe(true);
    expect(shortened).toMatchObject({ why: 'wrong', line: wrong, path, reason });
    expect(timeline.length).toBe(wrong - 2);
    expect(timeline.event(wrong - 2)).toEqual(JSON.parse(lines[wrong - 2] ?? ''));
    expect(timeline.event(wrong - 1)).toBeNull();
  });

  it('in a later block of the file, with the state reached', async () => {
    const [first = '', ...others] = lines.slice(0, -1);
    const events = others.slice(0, wrong - 2);
    const plane = events.find((line) => line.startsWith('{"e":"plane"')) ?? '';
    const long = [...events, ...Array.from({ length: 1500 }, () => plane)];
    const { shortened, timeline } = await keptOf(`${[first, ...long, 'oops'].join('\n')}\n`);
    expect(shortened).toMatchObject({ line: long.length + 2, reason: 'not JSON' });
    expect(timeline.length).toBe(long.length);
    const sound = await traceOf(`${lines.join('\n')}\n`);
    const { values } = sound.timeline.seek(wrong - 2);
    expect(timeline.seek(long.length).values.warnock?.stack).toEqual(values.warnock?.stack);
  });

  it('complete if it is the last line', async () => {
    const { shortened, timeline } = await keptOf(whole + linesOf(push));
    expect(shortened).toMatchObject({ why: 'wrong', line: 4, reason: 'text after the last line' });
    expect(timeline.length).toBe(1);
  });

  it('except before the first event, where there is no run', async () => {
    await expect(keptOf(linesOf(header, { e: 'boom' }))).rejects.toBeInstanceOf(Unreadable);
  });
});

describe('names beyond ASCII', () => {
  const named = textOf('small.warnock.signs.jsonl').replaceAll('"A"', '"Ёлка"');

  it('are read like others', async () => {
    const { timeline } = await traceOf(named);
    expect(timeline.length).toBe(named.split('\n').length - 3);
    expect(timeline.event(1)).toMatchObject({ e: 'plane', polygon: 'Ёлка' });
    expect(timeline.event(timeline.length)).toEqual(
      JSON.parse(named.trim().split('\n').at(-2) ?? ''),
    );
  });

  it('must be UTF-8 on every line', async () => {
    const file = bytes(named);
    const at = file.lastIndexOf(bytes('Ё')[0] ?? 0);
    file[at + 1] = 0x22;
    const error: unknown = await traceOf(file).catch((thrown: unknown) => thrown);
    const line = file.subarray(0, at).filter((byte) => byte === 10).length + 1;
    expect(error).toMatchObject({ line, reason: 'not JSON' });
  });
});

describe('a file that is not a trace is refused with line and reason', () => {
  it.each(broken)('%s', async (_name, file, line, reason) => {
    const error: unknown = await traceOf(file).then(
      () => null,
      (thrown: unknown) => thrown,
    );
    expect(error).toBeInstanceOf(Unreadable);
    const { line: found, reason: why } = error as Unreadable;
    expect([found, why]).toEqual([line, reason]);
  });
});
