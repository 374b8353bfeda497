import type { Plugin, Rollup } from 'vite';
import { licences } from './licences.js';

/** Puts the licences of a script's contents before it. */
export function licensed(workers: readonly Rollup.OutputChunk[]): Plugin {
  return {
    name: 'vidno-licensed',
    enforce: 'post',
    generateBundle(_options, bundle): void {
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk') continue;
        const text = `This script contains:\n\n${licences([chunk, ...workers])}`;
        chunk.code = `/*!\n${text.replaceAll('*/', '* /')}\n*/\n${chunk.code}`;
      }
    },
  };
}
