import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Rollup } from 'vite';

const contents = fileURLToPath(new URL('../../trace/wasm/LICENCES.md', import.meta.url));

/** The list of the library's components. */
export const libraryContents = (): string => readFileSync(contents, 'utf8').trim();

const ofPackage = /^.*\/node_modules\/(?:@[^/]+\/)?[^/]+/;

interface Manifest {
  readonly name: string;
  readonly version: string;
  readonly license: string;
}

function licenceIn(directory: string): string {
  const files = readdirSync(directory);
  const file = files.find((name) => /^licen[cs]e/i.test(name));
  if (file === undefined) throw new Error(`${directory} has no licence.`);
  // Some licences require a notice file to be passed on.
  const notice = files.filter((name) => /^notice$/i.test(name));
  return [file, ...notice]
    .map((name) => readFileSync(join(directory, name), 'utf8').trimEnd())
    .join('\n\n');
}

function nameIn(directory: string): string {
  const json = readFileSync(join(directory, 'package.json'), 'utf8');
  const { name, version, license } = JSON.parse(json) as Manifest;
  return `${name} ${version} (${license})`;
}

/** The packages whose code is in the page. */
function packagesOf(chunks: readonly Rollup.OutputChunk[]): readonly string[] {
  const used = chunks.flatMap(({ modules }) =>
    Object.keys(modules).filter((id) => (modules[id]?.renderedLength ?? 0) > 0),
  );
  // The name of a module converted from CommonJS begins with a zero byte.
  const files = used.map((id) => id.replace(/^\0/u, ''));
  return [...new Set(files.flatMap((id) => ofPackage.exec(id)?.[0] ?? []))].sort();
}

/** Names and licences of all packages in the page. A text that several share appears once. */
export function licences(chunks: readonly Rollup.OutputChunk[], further = ''): string {
  const names = new Map<string, string[]>();
  for (const directory of packagesOf(chunks)) {
    const text = licenceIn(directory);
    names.set(text, [...(names.get(text) ?? []), nameIn(directory)]);
  }
  const texts = [...names].map(([text, owners]) => `${owners.join(', ')}:\n\n${text}`);
  return (further === '' ? texts : [...texts, further]).join('\n\n');
}
