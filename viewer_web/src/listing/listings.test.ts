import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { allSamples } from '../testing/samples.js';
import { methods } from '../trace/events.js';
import { listingsOf } from './listings.js';

const detail = 'signs';

describe('the listings', () => {
  it.each(languages)('hold a line for each label of an event, in %s', (language) => {
    const labels = methods.flatMap((method) =>
      listingsOf({ method, edition: 'corrected', detail }, language).flatMap(({ lines }) =>
        lines.map(({ at }) => at),
      ),
    );
    for (const event of allSamples) expect(labels).toContain(event.at);
  });

  it('show the printed text with its defects', () => {
    const lines = listingsOf({ method: 'warnock', edition: 'printed', detail }, 'en').flatMap(
      (listing) => listing.lines,
    );
    const corrected = listingsOf({ method: 'warnock', edition: 'corrected', detail }, 'en').flatMap(
      (listing) => listing.lines,
    );
    const printed = lines.filter(({ defects }) => defects.length > 0);
    expect(printed.flatMap(({ defects }) => defects)).toContain('X-W3');
    expect(corrected.flatMap(({ defects }) => defects)).toEqual([]);
    expect(lines.length).toBe(corrected.length);
  });

  it('belong to a method', () => {
    const names = listingsOf({ method: 'zbuffer', edition: 'corrected', detail }, 'en').map(
      ({ name }) => name,
    );
    expect(names).toEqual(['ZBuffer', 'ShowLine', 'Depth', 'InitializePolygon']);
  });
});
