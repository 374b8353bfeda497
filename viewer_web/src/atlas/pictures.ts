import { toNumber } from '../language/words.js';
import type { Rectangle } from '../picture/frame.js';
import { patchesOf } from '../picture/patches.js';
import type { Shape } from '../picture/shapes.js';
import { boxData, pathData } from '../picture/shapes.js';
import { outlineData } from '../picture/still.js';
import type { Trace } from '../replay/trace.js';
import { usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import { Tracer } from '../run/tracer.js';
import type { Traced } from '../run/tracer.js';
import { outlines } from '../trace/polygon.js';
import type { Point } from '../trace/values.js';
import type { Entry } from './entries.js';

/** A small picture of the result of a run, in the plane of its scene. */
export interface Thumbnail {
  readonly shown: Rectangle;
  readonly shapes: readonly Shape[];
}

type Pair = readonly [number, number];
const numbers = ([x, y]: Point): Pair => [toNumber(x), toNumber(y)];

/** The painted pixels, with a frame around the wrong one; for curves, the lines drawn. */
function thumbnailOf({ header: { scene }, timeline }: Trace, wrong: Pair | null): Thumbnail {
  const { area, polygons, curves } = scene;
  const { length } = timeline;
  const shown = [area.x, area.y, area.width, area.height] as const;
  if (curves !== null) {
    const lines = timeline.linesAt(length);
    const ends = lines.map(({ from, to }) => pathData([numbers(from), numbers(to)], false));
    // Half a pixel, because the samples lie on the centres of columns.
    const [x, y, width, height] = shown;
    return {
      shown: [x - 0.5, y - 0.5, width, height],
      shapes: [{ look: 'line', d: ends.join('') }],
    };
  }
  const outlineOf = outlines(polygons);
  const patches = patchesOf(timeline.seek(length).screen.picture, area);
  return {
    shown,
    shapes: [
      ...patches.map(({ color, d }) => ({ look: 'patch', d, fill: color })),
      ...polygons.map((polygon) => ({
        look: 'outline',
        d: outlineData(outlineOf(polygon)),
        color: polygon.color,
      })),
      ...(wrong === null ? [] : [{ look: 'wrong', d: boxData([...wrong, 1, 1]) }]),
    ],
  };
}

/** A longer run shows its picture after this number of events. */
const mostEvents = 20_000;

/** The final pictures of the atlas's runs, made one at a time. */
export class Pictures {
  private readonly tracer: Tracer;
  private tell: (trace: Traced['trace']) => void = () => undefined;

  constructor(library: Blob) {
    this.tracer = new Tracer(
      library,
      ({ trace }) => this.tell(trace),
      () => this.tell(null),
    );
  }

  /** Null if there is no run, or the library does not make it. */
  async of({ scene, fails, shows }: Entry): Promise<Thumbnail | null> {
    if (scene === undefined || fails === undefined) return null;
    const options: Options = { ...usual, ...fails, detail: 'windows' };
    const traced = new Promise<Traced['trace']>((tell) => (this.tell = tell));
    this.tracer.run(JSON.stringify(scene), options, mostEvents);
    const trace = await traced;
    return trace && thumbnailOf(trace, shows?.pixel ?? null);
  }
}
