import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { HtmlTagDescriptor, Plugin } from 'vite';

const project = fileURLToPath(new URL('../../CMakeLists.txt', import.meta.url));

function versionOf(text: string): string {
  const version = /^project\(vidno VERSION ([\d.]+)/mu.exec(text)?.[1];
  if (version === undefined) throw new Error('CMakeLists.txt states no version.');
  return version;
}

/** States the version in the page's head, where the page reads it. */
export function version(): Plugin {
  return {
    name: 'vidno-version',
    transformIndexHtml(): HtmlTagDescriptor[] {
      const content = `vidno ${versionOf(readFileSync(project, 'utf8'))}`;
      return [{ tag: 'meta', attrs: { name: 'generator', content }, injectTo: 'head' }];
    },
  };
}
