import { describe, expect, it } from 'vitest';
import { questionFrom } from '../testing/questions.js';
import { textOf, traceOf } from '../testing/traces.js';
import { grade } from './grade.js';
import type { Answer } from './grade.js';
import type { Kind } from './question.js';
import { runOf, scoreOf } from './score.js';
import type { Answered } from './score.js';
import { emptySheet } from './sheet.js';

async function answered(
  name: string,
  kind: Kind,
  given: Answer | null,
  tries = 1,
): Promise<Answered> {
  const trace = await traceOf(textOf(`${name}.jsonl`));
  const question = questionFrom(trace, 1, kind);
  return {
    run: runOf(trace),
    way: 'forced',
    question,
    given,
    right: grade(question, given ?? []),
    sheet: emptySheet(question),
    tries,
  };
}

describe('a score', () => {
  it('counts first answers, by kind and by run, and keeps questions and answers', async () => {
    const right = [['A', 'B'], [''], ['split']];
    const score = scoreOf(
      [
        await answered('small.warnock.signs', 'window', right),
        await answered('small.warnock.signs', 'corners', [['lb'], ['<']], 3),
        await answered('small.zbuffer.signs', 'ael', null),
      ],
      'Ada',
    );
    expect(score).toMatchObject({
      format: 'vidno-score/1',
      name: 'Ada',
      total: { asked: 3, right: 1, given_up: 1, points: 4, parts: 8 },
      kinds: {
        window: { asked: 1, right: 1, given_up: 0 },
        corners: { asked: 1, right: 0, given_up: 0 },
        ael: { asked: 1, right: 0, given_up: 1 },
      },
      runs: [
        {
          scene: 'A square, a triangle and a slope',
          method: 'warnock',
          detail: 'signs',
          events: 1545,
        },
        { method: 'zbuffer', kernel: 'double', edition: 'corrected', events: 110 },
      ],
    });
    const [first, second] = score.runs;
    expect(
      first?.answers.map(({ step, kind, right: is, tries }) => [step, kind, is, tries]),
    ).toEqual([
      [4, 'window', true, 1],
      [37, 'corners', false, 3],
    ]);
    expect(first?.answers[1]?.parts).toEqual([
      {
        asks: 'nearer',
        options: ['lb', 'lt', 'rb', 'rt'],
        given: ['lb'],
        right: ['lb', 'rb', 'rt'],
        is_right: false,
        hints: 0,
      },
      {
        asks: 'cornerDepths',
        options: ['>', '=', '<'],
        given: ['<'],
        right: ['<'],
        is_right: true,
        hints: 0,
      },
    ]);
    expect(second?.answers[0]).toMatchObject({
      given_up: true,
      parts: [{ given: null }, { given: null }, { given: null }],
    });
  });

  it('has no name unless one is given', () => {
    expect(scoreOf([], '')).not.toHaveProperty('name');
  });
});
