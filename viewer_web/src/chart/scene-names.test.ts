import { expect, it } from 'vitest';
import { nameIn } from './scene-names.js';

it.each([
  ['A floor and a ramp', 'Пол и скат'],
  ['a scene of one’s own', 'a scene of one’s own'],
])('%s', (name, russian) => {
  expect([nameIn('en', name), nameIn('ru', name)]).toEqual([name, russian]);
});
