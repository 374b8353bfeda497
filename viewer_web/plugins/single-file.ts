import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin, Rollup } from 'vite';
import { licences } from './licences.js';

const contents = fileURLToPath(new URL('../../trace/wasm/LICENCES.md', import.meta.url));

const entryTag = /<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/;

/** Inside a script the parser only looks for its end and for comments. */
const inScript = (code: string): string =>
  code.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--').trim();

const hash = (text: string): string =>
  `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

function hashesOf(html: string, tag: RegExp): string {
  return [...html.matchAll(tag)].map((match) => hash(match[1] ?? '')).join(' ');
}

/**
 * Nothing is loaded, nothing is sent, only the page's own script and style count, and no text is markup. A worker's
 * script is made by the page's, and lives under the same policy; so is the drawing that becomes an image.
 */
function policy(html: string): string {
  return [
    "default-src 'none'",
    `script-src ${hashesOf(html, /<script type="module">([^]*?)<\/script>/g)}${html.includes('id="vidno-library"') ? " 'wasm-unsafe-eval'" : ''}`,
    `style-src ${hashesOf(html, /<style>([^]*?)<\/style>/g)}`,
    'worker-src blob:',
    'img-src blob:',
    "base-uri 'none'",
    "form-action 'none'",
    "require-trusted-types-for 'script'",
    'trusted-types lit-html vidno-worker',
  ].join('; ');
}

function inlined(html: string, code: string): string {
  const whole = html.replace(entryTag, () => `<script type="module">${inScript(code)}</script>`);
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy(whole)}" />`;
  return whole.replace('<meta charset="utf-8" />', (charset) => `${charset}\n    ${meta}`);
}

function takeChunk(bundle: Rollup.OutputBundle): Rollup.OutputChunk {
  const chunks = Object.values(bundle).filter((output) => output.type === 'chunk');
  const [chunk] = chunks;
  if (chunk === undefined || chunks.length > 1) throw new Error('The page must be one script.');
  // eslint-disable-next-line @typescript-eslint/no-dynamic-delete -- this is how a bundle loses a file
  delete bundle[chunk.fileName];
  return chunk;
}

/** What the library contains, if the page has it. */
function libraryIn(page: string): string {
  return page.includes('id="vidno-library"') ? readFileSync(contents, 'utf8').trim() : '';
}

/** Makes the page one file that opens from disk, under a security policy that names its script by hash. */
export function singleFile(file: string, workers: readonly Rollup.OutputChunk[] = []): Plugin {
  return {
    name: 'vidno-single-file',
    enforce: 'post',
    generateBundle(_options, bundle): void {
      const page = bundle[file];
      if (page?.type !== 'asset') throw new Error(`The build has no ${file}.`);
      const chunk = takeChunk(bundle);
      const source = String(page.source);
      const contained = licences([chunk, ...workers], libraryIn(source)).replaceAll('--', '- -');
      page.source = `${inlined(source, chunk.code)}<!--\nThis page contains:\n\n${contained}\n-->\n`;
    },
  };
}
