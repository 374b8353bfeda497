import { describe, expect, it } from 'vitest';
import { execFile } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { short } from '../language/words.js';
import type { Pixel } from '../picture/pixel.js';
import { traceOf as traceIn } from '../replay/trace.js';
import { make } from '../testing/made.js';
import { randomRuns } from '../testing/random-runs.js';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Method } from '../trace/events.js';
import { heightsOf } from './depth-column.js';
import { History } from './history.js';
import { standingsOf } from './reason.js';
import { reasonMarks } from './reason-marks.js';

/** The program that says why; `./dev test` names it. */
const program = process.env['VIDNO_PROGRAM'];

const square = (side: number, depthAt: (x: number) => number): readonly number[][] =>
  [
    [0, 0],
    [side, 0],
    [side, 4],
    [0, 4],
  ].map(([x = 0, y = 0]) => [x, y, depthAt(x)]);

/**
 * A is a square of 4 x 4 at depth 1/2. B is 8 x 4 and has depth x/16. C is a triangle at depth 3/4, whose edge 2 lies on
 * the line x = 6 + y/4. D is edge-on.
 */
const polygons = [
  { id: 'A', color: '#aa0000', vertices: square(4, () => 0.5) },
  { id: 'B', color: '#00aa00', vertices: square(8, (x) => x / 16) },
  {
    id: 'C',
    color: '#0000aa',
    vertices: [
      [6, 0, 0.75],
      [8, 0, 0.75],
      [8, 8, 0.75],
    ],
  },
  {
    id: 'D',
    color: '#aaaa00',
    vertices: [
      [0, 6, 0],
      [4, 6, 0],
      [2, 6, 1],
    ],
  },
];

function historyAt(pixel: Pixel, method: Method = 'zbuffer'): History {
  const header = headerOf(method) as { readonly scene: object };
  const text = textWith({ ...header, scene: { ...header.scene, polygons } }, []);
  return new History(traceIn(new TextEncoder().encode(text)), pixel);
}

function saidAt(pixel: Pixel): readonly string[] {
  const history = historyAt(pixel);
  const holding = history.holding();
  if (holding === null) throw new Error('no reasons');
  const { owner, ...places } = standingsOf(holding, polygons.length);
  return [owner, ...places.holding, ...places.others].map(
    (place) => history.reason(place, 'en').said,
  );
}

describe('the reasons at a pixel', () => {
  it('are exact: the owner first, then the polygons behind it', () => {
    // The centre is (5/2, 3/2). There B has depth 5/32, and 1/2 - 5/32 = 11/32. C's edge is at x = 6 + 3/8, and
    // 51/8 - 5/2 = 31/8. C is nearer than A, so it need not rise. Of A, the edges 0 and 1 are 3/2 away.
    expect(saidAt([2, 1])).toEqual([
      'A shows, at depth 1/2; if it sinks by more than 11/32, B shows; edge 0 of A passes 3/2 px above: if it moves down by more than that, A does not show',
      'B is 11/32 farther here; it shows if it rises by more than 11/32',
      'edge 2 of C passes 31/8 px to the right; C shows if edge 2 moves left by 31/8 px',
      'D is edge-on and shows nowhere',
    ]);
  });

  it('say that no polygon shows', () => {
    // The centre is (13/2, 13/2). C's edge is at x = 6 + 13/8, and 61/8 - 13/2 = 9/8.
    expect(saidAt([6, 6])).toEqual([
      'no polygon shows',
      'edge 1 of A passes 5/2 px to the left, edge 2 of A passes 5/2 px above; A shows if edge 1 moves right by 5/2 px and edge 2 moves down by 5/2 px',
      'edge 2 of B passes 5/2 px above; B shows if edge 2 moves down by 5/2 px',
      'edge 2 of C passes 9/8 px to the right; C shows if edge 2 moves left by 9/8 px',
      'D is edge-on and shows nowhere',
    ]);
  });

  it('are known where the method follows the picture rule alone', async () => {
    const methods = ['warnock', 'warnock-full', 'weiler-atherton', 'warnock-edges'] as const;
    const known = methods.filter((method) => historyAt([2, 1], method).holding() !== null);
    expect(known).toEqual(['warnock', 'warnock-full', 'weiler-atherton']);
    const curves = await traceOf(textOf('hills.floating-horizon.signs.jsonl'));
    expect(new History(curves, [1, 1]).holding()).toBeNull();
  });
});

describe('the marks of a reason', () => {
  function marksAt(pixel: Pixel, place: number): ReturnType<typeof reasonMarks> {
    const history = historyAt(pixel);
    const { at } = history.reason(place, 'en');
    if (at === null) throw new Error('no polygon');
    return reasonMarks(at, pixel, history.trace.header.scene, short);
  }

  it('are the separating edge, and its distance from the centre with its fraction', () => {
    expect(marksAt([2, 1], 2).slice(1)).toEqual([
      {
        kind: 'path',
        role: 'side',
        points: [
          [8, 8],
          [6, 0],
        ],
        closed: false,
      },
      {
        kind: 'path',
        role: 'reach',
        points: [
          [2.5, 1.5],
          [6.375, 1.5],
        ],
        closed: false,
      },
      { kind: 'note', at: [6.375, 1.5], text: '31/8' },
    ]);
  });

  it('extend an edge that ends before its line passes the centre', () => {
    const extended = marksAt([6, 6], 0).filter((mark) => 'role' in mark && mark.role === 'off');
    expect(extended).toEqual([
      {
        kind: 'path',
        role: 'off',
        points: [
          [4, 4],
          [4, 6.5],
        ],
        closed: false,
      },
      {
        kind: 'path',
        role: 'off',
        points: [
          [4, 4],
          [6.5, 4],
        ],
        closed: false,
      },
    ]);
  });

  it('are the outline alone for a polygon that is behind', () => {
    const [outline, ...others] = marksAt([2, 1], 1);
    expect(outline).toMatchObject({
      role: 'pointed',
      points: [
        [0, 0],
        [8, 0],
        [8, 4],
        [0, 4],
      ],
    });
    expect(others).toEqual([]);
  });
});

describe('the column of depths', () => {
  const depth = (text: string): Parameters<typeof heightsOf>[0]['owner'] => ({
    id: text,
    color: '#000000',
    depth: text,
    holds: true,
  });

  it('has one scale for all depths at the centre, the nearest on top', () => {
    // The scale goes from 20, the depth 1, down to 124, the depth 0. 20 + 104/4 = 46.
    const found = heightsOf({ owner: depth('1/1'), other: depth('3/4'), all: ['3/4', '0/1'] });
    expect([found.owner.at, found.other.at, found.all]).toEqual([20, 46, [46, 124]]);
  });

  it('keeps the labels apart, that of the nearer depth above', () => {
    const labelsOf = (owner: string, other: string): readonly number[] => {
      const found = heightsOf({ owner: depth(owner), other: depth(other), all: ['0/1', '1/1'] });
      return [found.owner.label, found.other.label];
    };
    expect(labelsOf('1/2', '1/2')).toEqual([72 - 21, 72 + 21]);
    expect(labelsOf('1/1', '99/100')).toEqual([28, 28 + 42]);
    expect(labelsOf('0/1', '1/100')).toEqual([118, 118 - 42]);
    expect(labelsOf('0/1', '1/1')).toEqual([118, 28]);
  });
});

const start = promisify(execFile);

/** What the program prints of the pixel. Its exit status is 1 if the run that it makes paints the pixel wrong. */
async function printed(scene: string, [x, y]: Pixel, language: Language): Promise<string> {
  const words = ['why', scene, `--pixel=${x},${y}`, '--language', language];
  try {
    return (await start(program ?? '', words)).stdout;
  } catch (error) {
    const { code, stdout } = error as { readonly code?: unknown; readonly stdout: string };
    if (code !== 1) throw error;
    return stdout;
  }
}

describe.runIf(program !== undefined)('the reasons in random scenes', () => {
  const own: readonly Method[] = ['floating-horizon', 'warnock-edges', 'warnock-bodies'];
  const runs = randomRuns(36, 11).filter(({ options }) => !own.includes(options.method));

  it('are those that `vidno why` prints', { timeout: 300_000 }, async () => {
    const folder = await mkdtemp(join(tmpdir(), 'vidno-'));
    const file = join(folder, 'scene.json');
    const seen = new Set<string>();
    try {
      for (const [number, run] of runs.entries()) {
        const { trace: text } = await make(program ?? '', run);
        const trace = await traceOf(text);
        const [header = ''] = text.split('\n');
        await writeFile(file, JSON.stringify((JSON.parse(header) as { scene: unknown }).scene));
        const { area, polygons: all } = trace.header.scene;
        for (let cell = number % 3; cell < area.width * area.height; cell += 3) {
          const pixel = [
            area.x + (cell % area.width),
            area.y + Math.floor(cell / area.width),
          ] as const;
          const history = new History(trace, pixel);
          const owner = history.holding()?.owner ?? null;
          const others = all.map((_, place) => place).filter((place) => place !== owner);
          const language = languages[cell % languages.length] ?? 'en';
          const said = (place: number | null): string => history.reason(place, language).said;
          const lines = (await printed(file, pixel, language))
            .split('\n')
            .slice(0, 1 + others.length);
          expect(lines[0]).toMatch(new RegExp(` ${pixel.join()}: `));
          expect([lines[0]?.replace(/^[^:]*: /, ''), ...lines.slice(1)]).toEqual([
            said(owner),
            ...others.map((place) => `  ${said(place)}`),
          ]);
          const standing = (place: number): string =>
            history.reason(place, 'en').at?.standing ?? '';
          expect(history.holding()?.holding).toEqual(
            all.flatMap((_, place) => (/shows|behind/.test(standing(place)) ? [place] : [])),
          );
          all.forEach((_, place) => seen.add(standing(place)));
        }
      }
    } finally {
      await rm(folder, { recursive: true });
    }
    expect([...seen].sort()).toEqual(['behind', 'beside', 'shows']);
  });
});
