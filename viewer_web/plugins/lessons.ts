import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { HtmlTagDescriptor, Plugin } from 'vite';

interface Index {
  readonly traces: readonly { readonly file: string }[];
}

const harmless = (json: string): string => json.replaceAll('<', '\\u003c');

function tags(directory: string): HtmlTagDescriptor[] {
  const json = readFileSync(join(directory, 'index.json'), 'utf8');
  const files = (JSON.parse(json) as Index[]).flatMap(({ traces }) => traces);
  return [
    block(
      { type: 'application/json', id: 'vidno-lessons' },
      harmless(JSON.stringify(JSON.parse(json))),
    ),
    ...files.map(({ file }) => {
      const attributes = { type: 'application/octet-stream', 'data-vidno-file': file };
      return block(attributes, readFileSync(join(directory, file)).toString('base64'));
    }),
  ];
}

function block(attrs: Record<string, string>, children: string): HtmlTagDescriptor {
  return { tag: 'script', attrs, children, injectTo: 'body' };
}

/**
 * Puts the lessons' index and traces into the page as blocks of data. They are no scripts to the browser, so
 * that another program, `vidno page`, may exchange them without touching what the page's security policy has hashed.
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
