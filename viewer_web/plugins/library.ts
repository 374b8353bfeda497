import { existsSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import type { HtmlTagDescriptor, Plugin } from 'vite';

/** Puts the library, compiled to WebAssembly, into the page as a block of data, packed. */
export function library(file: string): Plugin {
  return {
    name: 'vidno-library',
    transformIndexHtml: {
      order: 'post',
      handler(): HtmlTagDescriptor[] {
        if (!existsSync(file)) {
          console.warn(`\nNo ${file}: the page is built without live scenes.`);
          return [];
        }
        const children = gzipSync(readFileSync(file), { level: 9 }).toString('base64');
        const attrs = { type: 'application/octet-stream', id: 'vidno-library' };
        return [{ tag: 'script', attrs, children, injectTo: 'body' }];
      },
    },
  };
}
