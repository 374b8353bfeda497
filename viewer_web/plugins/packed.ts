import { gzipSync } from 'node:zlib';

/** Bytes or text in the form of a block of data: gzip, in base64. */
export const packed = (content: Buffer | string): string =>
  gzipSync(content, { level: 9 }).toString('base64');
