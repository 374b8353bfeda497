import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import { numberOf } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import { noticeOf, noticeOfRun } from './notice.js';

/** A trace that was read whole, with events of these names. */
const traceOf = (...names: readonly EventName[]): Trace =>
  ({
    complete: true,
    shortened: null,
    read: 1,
    timeline: {
      length: names.length,
      names: Uint8Array.from(names, (name) => numberOf.get(name) ?? 255),
    },
  }) as unknown as Trace;

describe('the notice about a run', () => {
  it('leads to the first of the steps at which something was lost', () => {
    const trace = traceOf('call', 'fault', 'clipped', 'fault');
    expect(noticeOf(trace)).toEqual({ kind: 'lost', step: 2, faults: 2 });
  });

  it.each([
    ['signs', false],
    ['windows', true],
  ])('says that the page has ended it, at the level %s', (detail, isCoarse) => {
    const ended = Object.assign(traceOf('call', 'clipped'), {
      header: { detail },
      shortened: { why: 'partial', line: 3 },
    }) as Trace;
    expect(noticeOfRun(ended)).toEqual({ kind: 'long', steps: 2, isCoarse });
  });

  it('is missing if nothing was lost', () => {
    expect(noticeOf(traceOf('call', 'clipped'))).toBeNull();
  });

  it.each(languages)('counts the losses and names the step (%s)', (language) => {
    const { lost, goToLoss } = texts[language].page;
    expect(lost(1, '57')).toMatch(/57/u);
    expect(lost(3, '57')).toMatch(/(?=.*3)(?=.*57)/u);
    expect(goToLoss('57')).toMatch(/57/u);
  });
});
