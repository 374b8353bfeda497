import { describe, expect, it } from 'vitest';
import { allSamples } from '../testing/samples.js';
import { methods, tells } from '../trace/events.js';
import { listingsOf } from './listings.js';
import { sourcesOf, linesThatReport } from './sources.js';

const warnock = { method: 'warnock', edition: 'corrected' } as const;

/** The lines marked at an event, as text. */
const marked = (at: string, e: string, run: Parameters<typeof sourcesOf>[0] = warnock) => {
  const event = allSamples.find((each) => each.e === e);
  if (event === undefined) throw new Error(e);
  return sourcesOf(run).flatMap((source) =>
    linesThatReport({ ...event, at } as typeof event, source).map((i) => source.lines[i]?.text),
  );
};

describe('the C++ of a run', () => {
  it('is a file for each procedure, in the order of the listings', () => {
    expect(sourcesOf(warnock).map(({ path }) => path)).toEqual([
      'warnock/warnock.h',
      'warnock/process_window.h',
      'warnock/surround_test.h',
      'warnock/depth.h',
      'warnock/point_color.h',
      'warnock/polygon_clip.h',
      'warnock/fill_polygon.h',
      'warnock/initialize_polygon.h',
      'corrected.h',
    ]);
  });

  it('belongs to the edition', () => {
    const printed = sourcesOf({ method: 'zbuffer', edition: 'printed' }).map(({ path }) => path);
    expect(printed).toContain('printed/show_line.h');
    expect(printed).toContain('warnock/depth.h'); // which is right in that text
    expect(printed.at(-1)).toBe('printed.h');
  });

  it('of a usual mistake ends with the usual rules and the mistake', () => {
    const paths = sourcesOf({ method: 'warnock', edition: 'one-list' }).map(({ path }) => path);
    expect(paths.slice(-2)).toEqual(['corrected.h', 'mistakes/one_list.h']);
    const list = sourcesOf({ method: 'warnock', edition: 'one-list' }).at(-1);
    expect(list?.lines.map(({ text }) => text)).toContain('return list;');
    const ofFamily = sourcesOf({ method: 'warnock-full', edition: 'line-for-edge' });
    expect(ofFamily.slice(-3).map(({ path }) => path)).toEqual([
      'family/family.h',
      'corrected.h',
      'mistakes/line_for_edge.h',
    ]);
    const files = (edition: 'boundary-outside' | 'depth-sign-reversed') =>
      sourcesOf({ method: 'warnock', edition }).map(({ path }) => path);
    expect(files('boundary-outside')).not.toContain('warnock/surround_test.h'); // it has its own version
    expect(files('depth-sign-reversed')).toContain('warnock/depth.h'); // which its own version calls
  });

  it('marks, among the lines with a label, the one that records the event', () => {
    expect(marked('PW6', 'compare')).toEqual([
      'run.trace.compare_corner(PW6, polygon, i, z[i], nearest[i], nearer[i]);',
    ]);
    expect(marked('PW6', 'nearer')).toEqual(['run.trace.nearer(PW6, polygon, nearer, k);']);
    expect(marked('PW5', 'depth')).toEqual([
      'for (int i = 0; i < 4; ++i) z[i] = run.depth(PW5, polygon, corners[i]);',
    ]);
  });

  it('has a line for each event except that of the planes, which are computed before the run', () => {
    for (const method of methods) {
      const sources = sourcesOf({ method, edition: 'corrected' });
      const labels = listingsOf({ method, edition: 'corrected', detail: 'signs' }, 'en').flatMap(
        ({ lines }) => lines.map(({ at }) => at),
      );
      const silent = allSamples
        .filter(({ e, at }) => e !== 'plane' && tells(method, e) && labels.includes(at))
        .filter((event) => sources.every((source) => linesThatReport(event, source).length === 0));
      expect(silent.map(({ e, at }) => `${e} ${at}`)).toEqual([]);
    }
  });
});
