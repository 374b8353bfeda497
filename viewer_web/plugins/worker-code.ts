import { build } from 'vite';
import type { Plugin, Rollup } from 'vite';

const query = '?code';

async function chunkOf(file: string): Promise<Rollup.OutputChunk> {
  const built = await build({
    configFile: false,
    logLevel: 'warn',
    build: {
      target: 'es2022',
      write: false,
      rollupOptions: { input: file, output: { format: 'iife' } },
    },
  });
  const [first] = 'output' in built ? built.output : [];
  if (first?.type !== 'chunk') throw new Error(`${file} must be one script.`);
  return first;
}

/**
 * `import code from './worker.js?code'` gives the script of a worker as text, because the page is one file. Collects the
 * chunks for the list of licences.
 */
export function workerCode(chunks: Rollup.OutputChunk[]): Plugin {
  return {
    name: 'vidno-worker-code',
    enforce: 'pre',
    async load(id): Promise<string | null> {
      if (!id.endsWith(query)) return null;
      const chunk = await chunkOf(id.slice(0, -query.length));
      chunks.push(chunk);
      return `export default ${JSON.stringify(chunk.code)};`;
    },
  };
}
