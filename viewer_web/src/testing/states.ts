import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

/**
 * The folder in which `./dev test` has written traces and, for each, the states of the program: one per line, from step 0.
 */
const folder = process.env['VIDNO_STATES'] ?? '';
const suffix = '.states.jsonl';

/** The traces that have such a file; empty without a folder. */
export const tracesWithStates: readonly string[] = (folder === '' ? [] : readdirSync(folder))
  .filter((name) => name.endsWith(suffix))
  .map((name) => name.slice(0, -suffix.length));

/** The content of a trace's file, plain or packed. */
export function traceIn(name: string): Uint8Array<ArrayBuffer> {
  const plain = join(folder, `${name}.jsonl`);
  return new Uint8Array(readFileSync(existsSync(plain) ? plain : `${plain}.gz`));
}

/** The states of a trace, as JSON. */
export function statesOf(name: string): readonly string[] {
  const lines = readFileSync(join(folder, name + suffix), 'utf8')
    .trim()
    .split('\n');
  return lines.map((line) => JSON.stringify(JSON.parse(line)));
}
