import { expect, it } from 'vitest';
import { methods } from '../trace/events.js';
import { textNames } from './text-names.js';

const named = (...run: Parameters<typeof textNames>): ReadonlyMap<string, string> =>
  new Map(textNames(...run).map(({ name, term }) => [name, term]));

it('has the names of the text that a method follows, beside ours', () => {
  expect(named('floating-horizon', 'en').get('Обрребра')).toBe('SideEdge');
  expect(named('floating-horizon', 'ru').get('Xребра, Yребра')).toBe('ребро');
  expect(named('warnock', 'en').has('Обрребра')).toBe(false);
  expect(named('warnock', 'en').has('приоритетный список')).toBe(false);
  expect(named('weiler-atherton', 'en').get('приоритетный список')).toBe('DepthSort(L)');
  expect(named('warnock-full', 'en').get('псевдоскалярное произведение')).toBe('u × v');
});

it('has names for every method', () => {
  for (const method of methods) expect(textNames(method, 'en').length).toBeGreaterThan(3);
});
