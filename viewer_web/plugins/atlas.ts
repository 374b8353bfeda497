import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { HtmlTagDescriptor, Plugin } from 'vite';
import { packed } from './packed.js';

/** The failures in a folder, by file name, each on one line. */
function entries(directory: string): readonly (readonly [name: string, text: string])[] {
  return readdirSync(directory)
    .filter((file) => file.endsWith('.json'))
    .sort()
    .map((file) => {
      const entry: unknown = JSON.parse(readFileSync(join(directory, file), 'utf8'));
      return [file.replace(/\.json$/u, ''), JSON.stringify(entry)] as const;
    });
}

/** Puts the atlas of failures into the page as a packed block of data. */
export function atlas(directory: string): Plugin {
  return {
    name: 'vidno-atlas',
    transformIndexHtml: {
      order: 'post',
      handler(): HtmlTagDescriptor[] {
        const children = packed(JSON.stringify(entries(directory)));
        const attrs = { type: 'application/octet-stream', id: 'vidno-atlas' };
        return [{ tag: 'script', attrs, children, injectTo: 'body' }];
      },
    },
  };
}
