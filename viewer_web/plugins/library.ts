import { existsSync, readFileSync } from 'node:fs';
import type { HtmlTagDescriptor, Plugin } from 'vite';
import { packed } from './packed.js';

/** Puts the library, compiled to WebAssembly, into the page as a packed block of data. */
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
        const children = packed(readFileSync(file));
        const attrs = { type: 'application/octet-stream', id: 'vidno-library' };
        return [{ tag: 'script', attrs, children, injectTo: 'body' }];
      },
    },
  };
}
