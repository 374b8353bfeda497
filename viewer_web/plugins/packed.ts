import { gzipSync } from 'node:zlib';

/** Bytes or a text as a block of data holds them: gzip, in base64. */
export const packed = (content: Buffer | string): string =>
  gzipSync(content, { level: 9 }).toString('base64');
