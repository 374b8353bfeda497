import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { inWords, lossInWords } from './library-reason.js';

const { en, ru } = texts;

it('a reason keeps the place and the file that it begins with', () => {
  const reason = 'cube.obj: line 3: not a number: x';
  expect(inWords(reason, en.scene)).toBe(reason);
  expect(inWords(reason, ru.scene)).toBe('cube.obj: строка 3: не число: x');
});

it('a file whose name contains a colon keeps it', () => {
  expect(inWords('a: b.stl: line 1: no format', ru.scene)).toBe(
    'a: b.stl: строка 1: нет строки format',
  );
});

it('what a scene lacks of a mesh is named with its place and how often it occurs', () => {
  const loss = 'line 12: left out: lines and points (3 times, here first)';
  expect(lossInWords(loss, en.scene)).toBe(loss);
  expect(lossInWords(loss, ru.scene)).toBe(
    'строка 12: пропущено: линии и точки (всего 3, здесь впервые)',
  );
  expect(lossInWords('face 7: left out: textures', ru.scene)).toBe('грань 7: пропущено: текстуры');
});
