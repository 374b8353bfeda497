import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { kindOfFile } from '../run/file-kind.js';
import { textOf as traceText, traceOf } from '../testing/traces.js';
import { textOf, toUtf8 } from './file.js';

const swapped = (bytes: Buffer): Buffer => Buffer.from(bytes).swap16();
const utf16 = (text: string): Buffer => Buffer.from(`\ufeff${text}`, 'utf16le');

/** The encodings that text editors write. */
const encodings: readonly (readonly [string, (text: string) => Buffer])[] = [
  ['UTF-8', (text) => Buffer.from(text)],
  ['UTF-8 with a mark', (text) => Buffer.from(`\ufeff${text}`)],
  ['UTF-16, little-endian', utf16],
  ['UTF-16, big-endian', (text) => swapped(utf16(text))],
];
const files = encodings.flatMap(([name, encoded]) => [
  [`${name}, plain`, encoded] as const,
  [`${name}, gzip`, (text: string) => gzipSync(encoded(text))] as const,
]);

const blob = (bytes: Buffer): Blob => new Blob([new Uint8Array(bytes)]);

describe.each(files)('a text in %s', (_name, encoded) => {
  it('is read with letters of any script', async () => {
    for (const text of ['', 'a', 'ab', 'Ёлка 🎄\r\n']) {
      expect(await textOf(blob(encoded(text)))).toBe(text);
    }
  });

  it('may be a trace', async () => {
    const text = traceText('small.zbuffer.signs.jsonl').replaceAll('"A"', '"Ёлка"');
    const trace = await traceOf(new Uint8Array(encoded(text.replaceAll('\n', '\r\n'))));
    expect(trace.shortened).toBeNull();
    expect(trace.timeline.length).toBe(text.split('\n').length - 3);
  });

  it('may be a scene', async () => {
    const scene = '{ "format": "vidno-scene/1", "name": "Ёлка" }';
    expect(await kindOfFile(blob(encoded(scene)))).toBe('scene');
    const trace = traceText('small.zbuffer.signs.jsonl');
    expect(await kindOfFile(blob(encoded(trace)))).toBe('trace');
  });
});

it.each(encodings)('%s may come byte by byte', async (_name, encoded) => {
  const text = 'Ёлка 🎄';
  const bytes = new Uint8Array(encoded(text));
  const stream = new ReadableStream<Uint8Array<ArrayBuffer>>({
    start(controller) {
      for (const byte of bytes) controller.enqueue(Uint8Array.of(byte));
      controller.close();
    },
  });
  const out = await new Response(stream.pipeThrough(toUtf8())).arrayBuffer();
  expect(Buffer.from(out).toString()).toBe(text);
});
