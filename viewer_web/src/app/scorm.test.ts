import { describe, expect, it } from 'vitest';
import { scoreOf } from '../predict/score.js';
import type { Score } from '../predict/score.js';
import { learningSystemOf } from './scorm.js';
import type { Frame } from './scorm.js';

/** A system that holds these data, with the calls it received. */
function systemWith(data: Readonly<Record<string, string>> = {}): {
  readonly API: object;
  readonly held: Map<string, string>;
  readonly calls: string[];
} {
  const held = new Map(Object.entries(data));
  const calls: string[] = [];
  const note = (name: string, answer: unknown = 'true'): unknown => {
    calls.push(name);
    return answer;
  };
  const API = {
    LMSInitialize: () => note('initialize'),
    LMSGetValue: (element: string) => held.get(element) ?? '',
    // Some systems answer with a boolean, which the standard does not have.
    LMSSetValue: (element: string, value: string) => note(element, !!held.set(element, value)),
    LMSCommit: () => note('commit'),
    LMSFinish: () => note('finish'),
  };
  return { API, held, calls };
}

type Page = Frame & EventTarget;

/** A page in windows with these properties, the nearest first. */
function pageIn(...windows: readonly object[]): Page {
  const outermost = { opener: null } as unknown as { parent: Frame };
  outermost.parent = outermost as unknown as Frame;
  const around = windows.reduceRight<Frame>(
    (parent, properties) =>
      Object.create(
        { parent, opener: null },
        Object.getOwnPropertyDescriptors(properties),
      ) as Frame,
    outermost as unknown as Frame,
  );
  return Object.assign(new EventTarget(), { parent: around, opener: null });
}

const otherOrigin = {
  get API(): never {
    throw new DOMException('Blocked a frame', 'SecurityError');
  },
};

function scoreWith(total: Partial<Score['total']>): Score {
  const empty = scoreOf([], '');
  return { ...empty, total: { ...empty.total, ...total } };
}

describe('the search for a learning management system', () => {
  it('finds the nearest window that has all functions', () => {
    const { API, calls } = systemWith();
    const further = systemWith();
    const page = pageIn({ API: { LMSInitialize: () => 'true' } }, { API }, { API: further.API });
    expect(learningSystemOf(page)).not.toBeNull();
    expect(calls).toContain('initialize');
    expect(further.calls).toEqual([]);
  });

  it('passes windows of other origins', () => {
    expect(learningSystemOf(pageIn(otherOrigin, { API: systemWith().API }))).not.toBeNull();
    expect(learningSystemOf(pageIn(otherOrigin))).toBeNull();
  });

  it('ends after seven windows around the page', () => {
    const { API } = systemWith();
    const empty = (count: number): readonly object[] => Array.from({ length: count }, () => ({}));
    expect(learningSystemOf(pageIn(...empty(6), { API }))).not.toBeNull();
    expect(learningSystemOf(pageIn(...empty(7), { API }))).toBeNull();
  });

  it('continues around the window that opened the page', () => {
    const { API } = systemWith();
    const opener = pageIn({}, { API });
    expect(learningSystemOf(Object.assign(pageIn(), { opener }))).not.toBeNull();
  });

  it('finds none around a page by itself', () => {
    expect(learningSystemOf(pageIn())).toBeNull();
  });
});

describe('a learning management system', () => {
  it('has a lesson begun, reported, completed and finished', () => {
    const { API, held, calls } = systemWith({ 'cmi.launch_data': '2' });
    const page = pageIn({ API });
    const system = learningSystemOf(page);
    expect(held.get('cmi.core.lesson_status')).toBe('incomplete');
    expect(held.has('cmi.core.score.raw')).toBe(false);

    // Two of three points, in one of two questions.
    system?.keep(scoreWith({ asked: 1, points: 2, parts: 3 }));
    expect(held.get('cmi.core.score.raw')).toBe('33.33');
    expect(held.get('cmi.core.lesson_status')).toBe('incomplete');
    expect([system?.percent, system?.left, calls.at(-1)]).toEqual([33.33, 1, 'commit']);

    system?.keep(scoreWith({ asked: 2, points: 3.5, parts: 5 }));
    expect(held.get('cmi.core.score.raw')).toBe('70');
    expect(held.get('cmi.core.lesson_status')).toBe('completed');
    expect([system?.percent, system?.left, calls.at(-1)]).toEqual([70, 0, 'commit']);

    page.dispatchEvent(new Event('pagehide'));
    expect(calls.at(-1)).toBe('finish');
  });

  it('gives back the score of the last visit, and a completed lesson remains so', () => {
    const earlier = scoreWith({ asked: 4, points: 3, parts: 6 });
    const { API, held } = systemWith({
      'cmi.launch_data': '5',
      'cmi.core.lesson_status': 'completed',
      'cmi.suspend_data': JSON.stringify(earlier),
    });
    const system = learningSystemOf(pageIn({ API }));
    expect(system?.earlier).toEqual(earlier);
    // Half of the points, in four of five questions.
    expect([system?.percent, system?.left]).toEqual([40, 1]);
    expect(held.get('cmi.core.lesson_status')).toBe('completed');
  });

  it('is asked for one question if it has no launch data', () => {
    expect(learningSystemOf(pageIn(systemWith()))?.left).toBe(1);
  });

  it.each([
    ['refuses a value', { LMSSetValue: (): string => 'false' }],
    ['refuses to commit', { LMSCommit: (): string => 'false' }],
    ['is not open', { LMSInitialize: (): string => 'false', LMSSetValue: (): string => 'false' }],
    [
      'fails',
      {
        LMSSetValue: (): never => {
          throw new Error('no connection');
        },
      },
    ],
  ])('has no score if it %s', (_, broken) => {
    const system = learningSystemOf(pageIn({ API: { ...systemWith().API, ...broken } }));
    expect(system?.percent).toBeNull();
    system?.keep(scoreWith({ asked: 1, points: 1, parts: 1 }));
    expect(system?.percent).toBeNull();
  });
});
