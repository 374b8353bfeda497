import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import type { RandomRun } from './random-runs.js';

const start = promisify(execFile);

/** A run that the program made, and the state after each step. */
export interface Made {
  readonly trace: string;
  readonly states: readonly string[];
}

/** Runs the program. A run that loses something is exit 1. */
async function evenLossy(program: string, words: readonly string[]): Promise<void> {
  try {
    await start(program, words);
  } catch (error) {
    if ((error as { readonly code?: unknown }).code !== 1) throw error;
  }
}

/** Makes a run with the program. */
export async function make(program: string, { scene, options }: RandomRun): Promise<Made> {
  const folder = await mkdtemp(join(tmpdir(), 'vidno-'));
  const [file, trace, states] = ['scene.json', 'run.jsonl', 'states.jsonl'].map((name) =>
    join(folder, name),
  ) as [string, string, string];
  const { method, edition, kernel, detail, check } = options;
  const how = ['--method', method, '--edition', edition, '--kernel', kernel, '--detail', detail];
  try {
    await writeFile(file, scene);
    await evenLossy(program, ['trace', file, ...how, ...(check ? ['--check'] : []), '-o', trace]);
    await evenLossy(program, ['replay', trace, '-o', states]);
    const lines = (await readFile(states, 'utf8')).trim().split('\n');
    return { trace: await readFile(trace, 'utf8'), states: lines };
  } finally {
    await rm(folder, { recursive: true });
  }
}
