import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { open, opened, shown, states } from './page.js';

/** Traces and, beside each, the states that the program itself went through, one a line from step 0. */
const directory = process.env['VIDNO_STATES'] ?? '';
const suffix = '.states.jsonl';
const names = (existsSync(directory) ? readdirSync(directory) : [])
  .filter((name) => name.endsWith(suffix))
  .map((name) => name.slice(0, -suffix.length));

function traceFile(name: string): string {
  const plain = join(directory, `${name}.jsonl`);
  return existsSync(plain) ? plain : `${plain}.gz`;
}

function expectedStates(name: string): readonly string[] {
  const lines = readFileSync(join(directory, name + suffix), 'utf8')
    .trim()
    .split('\n');
  return lines.map((line) => JSON.stringify(JSON.parse(line)));
}

async function openTrace(browser: Browser, name: string): Promise<Page> {
  const { page } = await open(browser, '#lang=en');
  const file = traceFile(name);
  await opened(page, name, readFileSync(file));
  return page;
}

describe.runIf(names.length > 0)('every step is the state of the program', () => {
  it.each(names)('%s, forward and backward', async (name) => {
    const page = await openTrace(browser, name);
    const expected = expectedStates(name);
    const { length } = await shown(page);
    expect(length).toBe(expected.length - 1);
    expect(await states(page, 0, length + 1)).toEqual(expected);
    expect(await states(page, length, -1)).toEqual([...expected].reverse());
  });
});
