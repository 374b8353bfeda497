import { expect, it } from 'vitest';
import { nameIn } from './scene-name.js';

it.each([
  ['A floor and a ramp', 'Пол и скат'],
  ['A floor and a ramp · 12', 'Пол и скат · 12'],
  ['a scene of one’s own', 'a scene of one’s own'],
  ['a scene · 2', 'a scene · 2'],
])('%s', (name, russian) => {
  expect([nameIn('en', name), nameIn('ru', name)]).toEqual([name, russian]);
});
