import { describe, expect, it } from 'vitest';
import { make } from '../testing/made.js';
import { everyQuestion } from '../testing/questions.js';
import { randomRuns } from '../testing/random-runs.js';
import type { RandomRun } from '../testing/random-runs.js';
import { rightAnswers } from '../testing/right-answers.js';
import { traceOf } from '../testing/traces.js';
import { isRight } from './grade.js';
import type { Kind } from './question.js';

/** The program that makes the runs; `./dev test` names it. */
const program = process.env['VIDNO_PROGRAM'];

const kernels = ['double', 'exact', 'filtered'];

/** Corrected runs of random scenes of polygons, with everything and checked: no question is about a wrong decision. */
const runs: readonly RandomRun[] = randomRuns(30, 11).flatMap(({ scene, options }, i) => {
  const { method } = options;
  if (!method.startsWith('warnock')) return [];
  const kernel = kernels[i % kernels.length] ?? 'double';
  return [
    { scene, options: { method, edition: 'corrected', kernel, detail: 'signs', check: true } },
  ];
});

const met = new Set<Kind>();

/** The parts of a run's questions that mark a right answer wrong. */
async function faultsOf(made: string, run: RandomRun): Promise<readonly string[]> {
  const trace = await traceOf((await make(made, run)).trace);
  return everyQuestion(trace).flatMap((question) => {
    const right = rightAnswers(trace, question);
    if (right === null) return [];
    met.add(question.kind);
    return question.parts.flatMap((part) => {
      const answer = right[part.asks];
      if (answer === undefined || isRight(part, answer)) return [];
      const about = JSON.stringify(question.about);
      return [
        `${run.options.method} ${run.options.kernel}, step ${question.step}, ${about}, ${part.asks}: ${answer.join(' ')} is right, not ${part.right.join(' ')}`,
      ];
    });
  });
}

describe.runIf(program !== undefined)('no right answer is marked wrong', () => {
  it('in random runs, where the scene gives the right answers in exact fractions', async () => {
    const wrong: string[] = [];
    for (const run of runs) wrong.push(...(await faultsOf(program ?? '', run)));
    expect(wrong.slice(0, 20)).toEqual([]);
    const kinds = ['window', 'relation', 'trial', 'inside', 'corners', 'point', 'depth', 'ray'];
    expect([...met].sort()).toEqual([...kinds, 'octants'].sort());
  }, 300_000);
});
