import { describe, expect, it } from 'vitest';
import { languages } from '../language/language.js';
import { floatingHorizonFacts } from '../testing/facts/floating-horizon.js';
import type { Fact, Facts, Moment, ProgramState } from '../testing/facts/fact.js';
import { familyFacts } from '../testing/facts/family.js';
import { Moments } from '../testing/facts/moments.js';
import { weilerAthertonFacts } from '../testing/facts/weiler-atherton.js';
import { zBufferFacts } from '../testing/facts/zbuffer.js';
import { faultOf } from '../testing/facts/shown.js';
import { warnockFacts } from '../testing/facts/warnock.js';
import { make } from '../testing/made.js';
import { randomRuns } from '../testing/random-runs.js';
import type { RandomRun } from '../testing/random-runs.js';
import { computedIn } from '../testing/saying.js';
import { traceOf } from '../testing/traces.js';
import type { Event, EventName } from '../trace/events.js';

/** The program that makes the runs; `./dev test` names it. */
const program = process.env['VIDNO_PROGRAM'];

const facts: Facts<EventName> = {
  ...warnockFacts,
  ...familyFacts,
  ...zBufferFacts,
  ...floatingHorizonFacts,
  ...weilerAthertonFacts,
};

/** The errors in the sentences of a run, and the events that occur in it. */
async function faultsOf(made: string, run: RandomRun): Promise<readonly string[]> {
  const { trace: text, states } = await make(made, run);
  const [header, ...lines] = text.trim().split('\n').slice(0, -1);
  const file = JSON.parse(header ?? '') as ConstructorParameters<typeof Moments>[0];
  const ids = (file.scene.polygons ?? []).map(({ id }) => id);
  const trace = await traceOf(text);
  const moments = new Moments(file);
  return lines.flatMap((line, i) => {
    const event = JSON.parse(line) as Event;
    const after = JSON.parse(states[i + 1] ?? '') as ProgramState;
    const moment = moments.take(event, after);
    const fact = (facts[event.e] as (event: Event, moment: Moment) => Fact)(event, moment);
    met.add(event.e);
    return languages.flatMap((language) => {
      const said = trace.timeline.sentence(i + 1, language);
      const fault = faultOf(computedIn(said), fact, ids, language);
      return fault === null ? [] : [`${line} “${said}” ${fault}`];
    });
  });
}

const met = new Set<EventName>();
const inTurn = 4;

describe.runIf(program !== undefined)('the sentences of 200 random runs', () => {
  it('agree with the events and the program’s states, in both languages', async () => {
    const waiting = [...randomRuns(200, 7)];
    const wrong: string[] = [];
    const work = async (): Promise<void> => {
      for (let run = waiting.pop(); run !== undefined; run = waiting.pop()) {
        const [first] = await faultsOf(program ?? '', run);
        if (first !== undefined) wrong.push(`${Object.values(run.options).join(' ')}: ${first}`);
      }
    };
    await Promise.all(Array.from({ length: inTurn }, work));
    expect(wrong).toEqual([]);
    const unmet = Object.keys(facts).filter((name) => !met.has(name as EventName));
    expect(unmet).toEqual([]);
  }, 300_000);
});
