// What the page says of each step of traces and of its decision, in each language, is what `vidno say` writes.
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

/** Whether the event of a step, counted from 0, is a `disagree`. */
function isDisagree(trace, at, length) {
  if (at >= length) return false;
  wasm.trace_line(trace, at + 1);
  return made().startsWith('{"e":"disagree"');
}

/** The lines of `vidno say`. A run that loses something is exit 1. */
function said(file, language) {
  const { status, stdout, stderr } = spawnSync(vidno, ['say', file, '--calculation', '--language', language], {
    encoding: 'utf8',
    maxBuffer: 2 ** 30,
  });
  if (status !== 0 && status !== 1) throw new Error(stderr);
  return stdout.trimEnd().split('\n');
}

/** The decision of a step, as `vidno say` writes it. */
function decision(trace, step, language) {
  wasm.trace_decision(trace, step, language);
  const text = made();
  if (text === '') return [];
  const { title, numbers, answers, judgement, calculations } = JSON.parse(text);
  decisions++;
  return [
    title,
    ...numbers.map(([name, number]) => `${name} = ${number}`),
    ...answers.map(([name, answer]) => `${name}: ${answer}`),
    judgement,
    ...calculations.flatMap(({ title, lines }) => [title, ...lines.map((line) => `    ${line}`)]),
  ].map((line) => `    ${line}`);
}

let sentences = 0;
let decisions = 0;
for (const file of files) {
  const bytes = readFileSync(file);
  const trace = opened(file.endsWith('.gz') ? gunzipSync(bytes) : bytes);
  const length = wasm.trace_length(trace);
  for (const [place, language] of languages.entries()) {
    const shown = Array.from({ length }, (_, i) => {
      wasm.trace_sentence(trace, i + 1, place);
      const [computed, ...exact] = made().split('\n').slice(0, 2);  // what is so instead has a line of its own
      const sentence = [`${i + 1}: ${computed}`, ...exact].join(' ');
      // A `disagree` is about the decision before it; if several follow each other, each is said after the one before.
      const [own, next] = [i, i + 1].map((at) => isDisagree(trace, at, length));
      if (own && !next) return [sentence];
      return [sentence, ...decision(trace, own ? i + 2 : i + 1, place)];
    }).flat();
    const lines = said(file, language);
    wasm.trace_shortened(trace);
    if (made() === '') shown.push(lines.at(-1)); // the verdict, which compares pictures
    deepStrictEqual(shown, lines, `${file} in ${language}`);
    sentences += length;
  }
  wasm.trace_close(trace);
}
console.log(`${sentences} sentences and ${decisions} decisions of ${files.length} traces are the same.`);
