import { describe, expect, it } from 'vitest';
import type { Pixel } from '../picture/pixel.js';
import { toColor } from '../replay/screen.js';
import { make } from '../testing/made.js';
import { randomRuns } from '../testing/random-runs.js';
import type { RandomRun } from '../testing/random-runs.js';
import { traceOf } from '../testing/traces.js';
import type { Polygon } from '../trace/header.js';
import { viewOf } from './view.js';

/** The program that makes the runs; `./dev test` names it. */
const program = process.env['VIDNO_PROGRAM'];

const shown = { language: 'en', pixel: null, pointed: null } as const;

interface SceneFile {
  readonly polygons: readonly Pick<Polygon, 'id' | 'color'>[];
}

/** The same run with a colour for each polygon that nothing else has. */
function inDistinctColors({ scene, options }: RandomRun): RandomRun {
  const { polygons, ...rest } = JSON.parse(scene) as SceneFile;
  const repainted = polygons.map((each, i) => ({
    ...each,
    color: `#0000${(16 + i).toString(16)}`,
  }));
  return { scene: JSON.stringify({ ...rest, polygons: repainted }), options };
}

/** Compares the owners of each pixel at each step with its colour in the same run in distinct colours. */
async function compareOwners(run: RandomRun): Promise<void> {
  const [trace, distinct] = await Promise.all(
    [run, inDistinctColors(run)].map(async (each) =>
      traceOf((await make(program ?? '', each)).trace),
    ),
  );
  if (trace === undefined || distinct === undefined) throw new Error('two runs');
  const { area, polygons } = distinct.header.scene;
  expect(distinct.timeline.length).toBe(trace.timeline.length);
  for (let step = trace.timeline.length; step > 0; step -= 7) {
    const { ownersAt, screen } = viewOf(trace, step, shown);
    const { picture } = viewOf(distinct, step, shown).screen;
    for (let j = 0; j < area.height; j++) {
      for (let i = 0; i < area.width; i++) {
        const owners = ownersAt([area.x + i, area.y + j] as Pixel);
        if (owners === null) {
          expect(screen.painter(area.x + i, area.y + j)).toBe(0);
          continue;
        }
        const right = polygons.find(({ color }) => color === toColor(picture.at(i, j)));
        const found = [...owners.polygons, ...(owners.background ? [null] : [])];
        expect(found).toContain(right?.id ?? null);
        // At the level of windows a fill has only its colour.
        if (run.options.detail !== 'windows') expect(found).toHaveLength(1);
      }
    }
  }
}

describe.runIf(program !== undefined)('the owners of pixels', () => {
  const runs = randomRuns(120, 5).filter(({ options }) => options.method !== 'floating-horizon');

  it.each(runs)('are polygons, not colours: $options', { timeout: 60_000 }, compareOwners);
});
