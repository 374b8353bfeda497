import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import { answers, questionFrom } from '../testing/questions.js';
import { textOf, traceOf } from '../testing/traces.js';

/**
 * A line at height 1.5, and behind it one from 3 over column 0 to -1 over column 4: 3, 2, 1, 0, -1. Heights grow downward.
 */
const crossing = (): Promise<Trace> => traceOf(textOf('crossing.floating-horizon.signs.jsonl'));

describe('the floating horizon asks', () => {
  it('over which columns a curve is visible above, and below', async () => {
    const question = questionFrom(await crossing(), 1, 'flags');
    expect(question.about.curve).toBe(1);
    expect(answers(question)).toEqual({ above: ['2', '3', '4'], below: ['1'] });
    const second = question.parts[0]?.options[1];
    expect(second?.value).toBe('2');
    expect(languages.map((language) => second?.note?.(texts[language]))).toEqual([
      'y = 1; upper 1.5; lower 1.5',
      'y = 1; верхний 1,5; нижний 1,5',
    ]);
  });

  it('over which columns the horizons change', async () => {
    // The second line lies below the first over columns 0 and 1.
    const question = questionFrom(await crossing(), 1, 'horizons');
    expect(answers(question)).toEqual({ raised: [], lowered: ['0', '1'] });
  });

  it('which horizon is met, and where', async () => {
    // The first curve falls from 4.5 over column 1 to 3 over column 2, the second one lies lower. The segment at 4 leaves the
    // upper horizon where 4.5 − 1.5 t = 4, at x = 4/3, and is hidden from there on.
    const hills = await traceOf(textOf('hills.floating-horizon.signs.jsonl'));
    const question = questionFrom(hills, 1, 'meeting');
    expect(question.about.curve).toBe(2);
    expect(answers(question)).toEqual({ meets: ['upper'], where: ['between'] });
  });

  it('nothing about a meeting with both horizons, where either answer is right', async () => {
    const trace = await crossing();
    expect(() => questionFrom(trace, 1, 'meeting')).toThrow('no meeting');
  });

  it('nothing without events of heights, and nothing about the first curve', async () => {
    const hills = await traceOf(textOf('hills.floating-horizon.signs.jsonl'));
    expect(questionFrom(hills, 1, 'flags').about.curve).toBeGreaterThan(0);
    const coarse = await traceOf(textOf('hills.floating-horizon.polygons.jsonl'));
    expect(() => questionFrom(coarse, 1, 'flags')).toThrow('no flags');
  });
});
