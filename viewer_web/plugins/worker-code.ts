import { build } from 'vite';
import type { Plugin } from 'vite';

const query = '?code';

async function codeOf(file: string): Promise<string> {
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
  return first.code;
}

/** `import code from './worker.js?code'` is the script of a worker as text: the page is one file. */
export function workerCode(): Plugin {
  return {
    name: 'vidno-worker-code',
    enforce: 'pre',
    async load(id): Promise<string | null> {
      if (!id.endsWith(query)) return null;
      return `export default ${JSON.stringify(await codeOf(id.slice(0, -query.length)))};`;
    },
  };
}
