import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

/** Where `./dev test` has written traces and, beside each, the states that the program went through: one a line, from step 0. */
const folder = process.env['VIDNO_STATES'] ?? '';
const suffix = '.states.jsonl';

/** The traces that have such a file; none where no folder is given. */
export const tracesWithStates: readonly string[] = (folder === '' ? [] : readdirSync(folder))
  .filter((name) => name.endsWith(suffix))
  .map((name) => name.slice(0, -suffix.length));

/** A trace as its file is: plain, or packed. */
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
