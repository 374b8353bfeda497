import { Readable, Writable } from 'node:stream';
import type { Duplex } from 'node:stream';
import { createDeflateRaw, createInflateRaw } from 'node:zlib';

/** Node 18, which Debian 12 has, lacks a format of streams that all browsers know. */
function withRaw<Native extends new (format: CompressionFormat) => GenericTransformStream>(
  native: Native,
  raw: () => Duplex,
): Native {
  try {
    new native('deflate-raw');
    return native;
  } catch {
    return function (format: CompressionFormat) {
      if (format !== 'deflate-raw') return new native(format);
      const both = raw();
      return { readable: Readable.toWeb(both), writable: Writable.toWeb(both) };
    } as unknown as Native;
  }
}

globalThis.CompressionStream = withRaw(CompressionStream, createDeflateRaw);
globalThis.DecompressionStream = withRaw(DecompressionStream, createInflateRaw);
