import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { HtmlTagDescriptor, Plugin } from 'vite';
import { packed } from './packed.js';

/** Why a wrong picture has no proof, in each language. `lessons/failures/table.mjs` writes it. */
interface Unproved {
  readonly name: string;
}

/** The failures in a folder, by file name, each on one line, with the reason why its picture has no proof, or null. */
export function entries(
  directory: string,
): readonly (readonly [name: string, text: string, unproved: Unproved | null])[] {
  const read = (file: string): string => readFileSync(join(directory, file), 'utf8');
  const unproved = read('unproved.jsonl')
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line) as Unproved);
  return readdirSync(directory)
    .filter((file) => file.endsWith('.json'))
    .sort()
    .map((file) => {
      const name = file.replace(/\.json$/u, '');
      const reason = unproved.find((each) => each.name === name) ?? null;
      return [name, JSON.stringify(JSON.parse(read(file))), reason] as const;
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
