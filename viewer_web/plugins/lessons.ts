import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { HtmlTagDescriptor, Plugin } from 'vite';
import { jsonInPage } from '../src/base/markup.js';

interface Index {
  readonly traces: readonly { readonly file: string }[];
  readonly story?: string;
}

function tags(directory: string): HtmlTagDescriptor[] {
  const json = readFileSync(join(directory, 'index.json'), 'utf8');
  const lessons = JSON.parse(json) as Index[];
  const traces = lessons.flatMap((lesson) => lesson.traces.map(({ file }) => file));
  const stories = lessons.flatMap(({ story }) => story ?? []);
  const file = (name: string): Buffer => readFileSync(join(directory, name));
  return [
    block({ type: 'application/json', id: 'vidno-lessons' }, jsonInPage(lessons)),
    ...fileBlocks([
      ...traces.map((name) => [name, file(name)] as const),
      ...stories.map((name) => [name, gzipSync(file(name), { level: 9 })] as const),
    ]),
  ];
}

/** A block for each file. If several have the same content, the first block has it, and the others name that block. */
function fileBlocks(
  files: readonly (readonly [name: string, bytes: Buffer])[],
): HtmlTagDescriptor[] {
  const names = new Map<string, string>();
  return files.map(([name, bytes]) => {
    const content = bytes.toString('base64');
    const attributes = { type: 'application/octet-stream', 'data-vidno-file': name };
    const same = names.get(content);
    if (same !== undefined) return block({ ...attributes, 'data-vidno-same': same }, '');
    names.set(content, name);
    return block(attributes, content);
  });
}

function block(attrs: Record<string, string>, children: string): HtmlTagDescriptor {
  return { tag: 'script', attrs, children, injectTo: 'body' };
}

/**
 * Puts the lessons' index, traces and stories into the page as blocks of data. The browser does not execute them, so that
 * the program `vidno page` can exchange them without affecting the hashes of the page's security policy.
 */
export function lessons(directory: string): Plugin {
  return {
    name: 'vidno-lessons',
    transformIndexHtml: {
      order: 'post',
      handler(): HtmlTagDescriptor[] {
        if (existsSync(join(directory, 'index.json'))) return tags(directory);
        console.warn(`\nNo index.json in ${directory}: the page is built without lessons.`);
        return [];
      },
    },
  };
}
