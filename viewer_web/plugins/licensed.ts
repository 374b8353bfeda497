import type { Plugin } from 'vite';
import { libraryContents, licences } from './licences.js';

/** Puts the licences of a script's contents before it; the script contains the library. */
export function licensed(): Plugin {
  return {
    name: 'vidno-licensed',
    enforce: 'post',
    generateBundle(_options, bundle): void {
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk') continue;
        const text = `This script contains:\n\n${licences([chunk], libraryContents())}`;
        chunk.code = `/*!\n${text.replaceAll('*/', '* /')}\n*/\n${chunk.code}`;
      }
    },
  };
}
