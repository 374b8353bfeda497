import { expect, it } from 'vitest';
import { isTrusted, requestIn } from './messages.js';

it.each([
  [
    { vidno: 'go', step: 12 },
    { vidno: 'go', step: 12 },
  ],
  [{ vidno: 'next' }, { vidno: 'next' }],
  [{ vidno: 'previous', other: 1 }, { vidno: 'previous' }],
  [{ vidno: 'what' }, { vidno: 'what' }],
  [{ vidno: 'go', step: '12' }, null],
  [{ vidno: 'go' }, null],
  [{ vidno: 'run' }, null],
  ['next', null],
  [null, null],
])('the request in %j is %j', (data, request) => {
  expect(requestIn(data)).toEqual(request);
});

const served = { protocol: 'https:', origin: 'https://course.example' };
const file = { protocol: 'file:', origin: 'null' };
const slides = ['https://slides.example'];

it.each([
  ['https://course.example', served, [], true],
  ['https://slides.example', served, [], false],
  ['https://slides.example', served, slides, true],
  ['https://slides.example.evil', served, slides, false],
  // A frame that may not have an origin.
  ['null', served, slides, false],
  ['null', file, [], true],
  ['file://', file, [], true],
  ['https://slides.example', file, [], false],
] as const)('messages from %s to %o, which names %j: %s', (origin, own, named, isAllowed) => {
  expect(isTrusted(origin, own, named)).toBe(isAllowed);
});
