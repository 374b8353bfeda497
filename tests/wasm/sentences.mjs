// What the page says of each step of traces, in each language, is what `vidno say` writes.
//
//     node sentences.mjs REPLAY.wasm VIDNO TRACE...
import { deepStrictEqual } from 'node:assert';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { engineOf } from './engine.mjs';

const [module, vidno, ...files] = process.argv.slice(2);
const languages = ['en', 'ru'];
const { wasm, made, opened } = engineOf(module);

/** The lines of `vidno say`. A run that loses something is exit 1. */
function said(file, language) {
  const { status, stdout, stderr } = spawnSync(vidno, ['say', file, '--language', language], {
    encoding: 'utf8',
    maxBuffer: 2 ** 30,
  });
  if (status !== 0 && status !== 1) throw new Error(stderr);
  return stdout.trimEnd().split('\n');
}

let sentences = 0;
for (const file of files) {
  const bytes = readFileSync(file);
  const trace = opened(file.endsWith('.gz') ? gunzipSync(bytes) : bytes);
  const length = wasm.trace_length(trace);
  for (const [place, language] of languages.entries()) {
    const shown = Array.from({ length }, (_, i) => {
      wasm.trace_sentence(trace, i + 1, place);
      const [computed, ...exact] = made().split('\n').slice(0, 2);  // what is so instead has a line of its own
      return [`${i + 1}: ${computed}`, ...exact].join(' ');
    });
    deepStrictEqual(shown, said(file, language), `${file} in ${language}`);
    sentences += length;
  }
  wasm.trace_close(trace);
}
console.log(`${sentences} sentences of ${files.length} traces are the same.`);
