import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { Library } from './library.js';
import { faultsOf, inWordsOf } from './refusal.js';

/** Pseudorandom numbers below `n`, by the generator of Park and Miller. */
function chance(seed: number): (n: number) => number {
  let now = seed;
  return (n) => {
    now = (now * 48_271) % 2_147_483_647;
    return now % n;
  };
}

const program = process.env['VIDNO_PROGRAM'] ?? '';
const module = join(dirname(program), 'wasm/vidno.wasm');

type Below = (n: number) => number;

const oneOf = (below: Below, list: readonly string[]): string => list[below(list.length)] ?? '';

const functions = ['sin', 'cos', 'atan', 'exp', 'sqrt', 'abs', 'floor', 'tanh', 'log'] as const;

/** A formula that the program takes, as a tree of this depth. */
function formula(below: Below, depth: number): string {
  if (depth === 0) return oneOf(below, ['x', 'z', 'pi', 'e', '2', '.5', '1e1', '0.3']);
  const part = (): string => formula(below, depth - 1);
  switch (below(7)) {
    case 0:
      return `${oneOf(below, functions)}(${part()})`;
    case 1:
      return `max(${part()}, ${part()})`;
    case 2:
      return `(${part()} ${oneOf(below, ['<', '>=', '==', '!='])} ${part()} ? ${part()} : ${part()})`;
    case 3:
      return `(${part()})${oneOf(below, ['^', '**'])}${oneOf(below, ['2', '3', '-1', 'x'])}`;
    case 4:
      return `-${part()}`;
    default:
      return `(${part()} ${oneOf(below, ['+', '-', '*', '/'])} ${part()})`;
  }
}

/** The formula, perhaps with a usual slip: a character missing, doubled, or replaced. */
function perhapsWithSlip(below: Below, right: string): string {
  const at = below(right.length);
  const [before, here, after] = [right.slice(0, at), right.charAt(at), right.slice(at + 1)];
  switch (below(6)) {
    case 0:
      return before + after;
    case 1:
      return before + here + here + after;
    case 2:
      return before + oneOf(below, [',', 'y', '|', '=', '&', '!', ' ', '²', '2x', 'sin']) + after;
    default:
      return right;
  }
}

const surface = (text: string): string =>
  JSON.stringify({
    window: { x: 0, y: 0, width: 8, height: 8 },
    function: text,
    x: [0.25, 1.75],
    z: [1.5, 0.5],
    curves: 2,
    samples: 3,
    view: { origin: [0, 4], across: [6, 0], back: [1, -1], up: 1 },
  });

/** The samples of a surface, or why its formula is refused. */
type Outcome = readonly number[] | string;

const samplesOf = (trace: string): readonly number[] => {
  const header = JSON.parse(trace.slice(0, trace.indexOf('\n'))) as {
    readonly scene: { readonly curves: readonly (readonly [number, number | null])[][] };
  };
  return header.scene.curves.flat().map(([, y]) => y ?? NaN);
};

const reasonOf = (messages: string): string =>
  faultsOf(messages.replace(/^vidno: /u, ''))[0]?.reason ?? '';

describe.skipIf(!existsSync(module))('Formulas in the page and in the program', () => {
  const folder = mkdtempSync(join(tmpdir(), 'vidno-'));
  afterAll(() => rmSync(folder, { recursive: true }));
  let library: Library;
  beforeAll(async () => {
    library = new Library(await WebAssembly.compile(readFileSync(module)));
  });

  function inPage(text: string): Outcome {
    const options = { method: 'floating-horizon', edition: 'corrected', kernel: 'double' };
    const request = { ...options, detail: 'windows', check: false, most_events: 10000 };
    const { made, messages } = library.run(
      `${JSON.stringify(request)}\n${surface(text)}`,
      (bytes) => new TextDecoder().decode(bytes),
    );
    return made === null ? reasonOf(messages) : samplesOf(made);
  }

  const file = join(folder, 'surface.json');
  function inProgram(text: string): Outcome {
    writeFileSync(file, surface(text));
    try {
      const stdio = ['ignore', 'pipe', 'pipe'] as const;
      return samplesOf(
        execFileSync(program, ['trace', file, '-o', '-'], { encoding: 'utf8', stdio: [...stdio] }),
      );
    } catch (error) {
      return reasonOf((error as { readonly stderr: string }).stderr.replaceAll(`${file}: `, ''));
    }
  }

  it('500 formulas are taken with the same values, or refused with the same reason', () => {
    const below = chance(1);
    let taken = 0;
    for (let i = 0; i < 500; ++i) {
      const text = perhapsWithSlip(below, formula(below, 1 + below(3)));
      const [page, own] = [inPage(text), inProgram(text)];
      if (typeof page === 'string' || typeof own === 'string') {
        expect(page, text).toBe(own);
        const fault = { line: null, column: null, place: '', reason: String(own) };
        const said = inWordsOf(fault, texts.ru.scene);
        expect(said, text).toMatch(/\p{Script=Cyrillic}/u);
      } else {
        expect(page.length, text).toBe(own.length);
        expect(page.map(Number.isNaN), text).toEqual(own.map(Number.isNaN));
        page.forEach((y, at) => expect(y / (own[at] ?? NaN) || 1, text).toBeCloseTo(1, 9));
        taken += 1;
      }
    }
    expect(taken).toBeGreaterThan(150);
  }, 300_000);
});
