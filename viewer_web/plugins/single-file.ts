import { createHash } from 'node:crypto';
import type { Plugin, Rollup } from 'vite';
import { libraryContents, licences } from './licences.js';
import { packed } from './packed.js';

const entryTag = /<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/;

/**
 * Unpacks the page's script while the rest of the page loads, then starts it. The packed script has a third of the size.
 */
const loader = `(async () => {
  const { text } = document.getElementById('vidno-script');
  const bytes = Uint8Array.fromBase64?.(text) ?? Uint8Array.from(atob(text), (byte) => byte.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const code = await new Response(stream).text();
  if (document.readyState === 'loading') {
    await new Promise((parsed) => document.addEventListener('DOMContentLoaded', parsed));
  }
  const rules = { createScript: (text) => text };
  const vouched = globalThis.trustedTypes?.createPolicy('vidno-script', rules);
  const script = document.createElement('script');
  script.type = 'module';
  script.text = vouched?.createScript(code) ?? code;
  document.head.append(script);
})();`;

const hash = (text: string): string =>
  `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

function scriptTags(code: string): string {
  return [
    `<script type="application/octet-stream" id="vidno-script">${packed(code)}</script>`,
    `<script>${loader}</script>`,
  ].join('\n    ');
}

/** The page of cost against error has none. */
const hasLibrary = (code: string): boolean => code.includes('WebAssembly');

/**
 * The policy forbids loading and sending anything. It allows only the page's own script and style, and no text as markup.
 * The page makes the scripts of workers, which run under the same policy; so does the drawing that becomes an image.
 */
function policy(html: string, code: string): string {
  const styles = [...html.matchAll(/<style>([^]*?)<\/style>/g)];
  return [
    "default-src 'none'",
    `script-src ${hash(loader)} ${hash(code)}${hasLibrary(code) ? " 'wasm-unsafe-eval'" : ''}`,
    `style-src ${styles.map((match) => hash(match[1] ?? '')).join(' ')}`,
    'worker-src blob:',
    'img-src blob:',
    "base-uri 'none'",
    "form-action 'none'",
    "require-trusted-types-for 'script'",
    'trusted-types lit-html vidno-script vidno-worker',
  ].join('; ');
}

function inlined(html: string, code: string): string {
  const whole = html.replace(entryTag, () => scriptTags(code));
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy(whole, code)}" />`;
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

/** A browser needs a third more time to read a page with any other characters than those of ASCII. */
const inComment = (text: string): string =>
  text.replaceAll('--', '- -').replace(/[“”]/g, '"').replaceAll('©', '(c)');

/** Makes the page one file that opens from disk, with a security policy that names its script by hash. */
export function singleFile(file: string, workers: readonly Rollup.OutputChunk[] = []): Plugin {
  return {
    name: 'vidno-single-file',
    enforce: 'post',
    generateBundle(_options, bundle): void {
      const page = bundle[file];
      if (page?.type !== 'asset') throw new Error(`The build has no ${file}.`);
      const chunk = takeChunk(bundle);
      const source = String(page.source);
      const contained = inComment(
        licences([chunk, ...workers], hasLibrary(chunk.code) ? libraryContents() : ''),
      );
      page.source = `${inlined(source, chunk.code)}<!--\nThis page contains:\n\n${contained}\n-->\n`;
      if (/[^\0-\x7f]/.test(page.source)) throw new Error(`${file} must be ASCII.`);
    },
  };
}
