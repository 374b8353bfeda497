import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import { faultsOf, inWordsOf, refusalOf, whyRefused } from './refusal.js';
import { addPolygon, emptySketch } from './sketch.js';

const drawn = addPolygon(emptySketch, [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
]);

it.each([
  ['scene: /polygons/0/vertices: not planar', 'A', 'not planar'],
  ['scene: /polygons/0/vertices/1/2: z outside -1 to 1\n', 'A', 'z outside -1 to 1'],
  ['scene: /window/width: not from 1 to 16384', '/window/width', 'not from 1 to 16384'],
  ['scene: line 2, column 3: not valid JSON', null, 'not valid JSON'],
  [
    'scene: line 1, column 60: /polygons/0/vertices/2: not convex, and the edges from [0,0,0] and [2,0,0] cross; cut the polygon there',
    'A',
    'not convex, and the edges from [0,0,0] and [2,0,0] cross; cut the polygon there',
  ],
  [
    'scene: line 1, column 60: /polygons/0/color: not a string\nscene: line 1, column 80: /name: not a string',
    'A',
    'not a string',
  ],
  ['scene: /polygons/7: twice', '/polygons/7', 'twice'],
  ['scene: polygon my face has no area', 'my face', 'has no area'],
  [
    'scene: polygon A has a vertex of polygon B in front of it: its body is not convex, or its vertices are in the opposite order',
    'A',
    'has a vertex of another one in front of it: its body is not convex, or its vertices are in the opposite order',
  ],
])('%s', (message, polygon, reason) => {
  expect(refusalOf(message, drawn)).toEqual({ polygon, reason });
});

it('is given in the language of the page, with its subject', () => {
  const said = whyRefused('scene: /function: rint: no such function', drawn, texts.ru.scene);
  expect(said).toBe('Формула: rint: такой функции нет');
  const message = 'scene: /function: not finite at any sample';
  expect(languages.map((each) => whyRefused(message, drawn, texts[each].scene))).toEqual([
    'The formula: not finite at any sample',
    'Формула: не имеет конечного значения ни в одном отсчёте',
  ]);
});

it('gives each error of a file with its place', () => {
  const faults = faultsOf(
    'scene: line 3, column 14: /polygons/0/color: not a string\n' +
      'scene: line 7, column 5: /polygons/1: "vertices" is missing\n' +
      'scene: line 9, column 1: not valid JSON\n',
  );
  expect(faults.map((each) => inWordsOf(each, texts.en.scene))).toEqual([
    'line 3, column 14: /polygons/0/color: not a string',
    'line 7, column 5: /polygons/1: “vertices” is missing',
    'line 9, column 1: not valid JSON',
  ]);
  expect(faults.map((each) => inWordsOf(each, texts.ru.scene))).toEqual([
    'строка 3, символ 14: /polygons/0/color: не строка',
    'строка 7, символ 5: /polygons/1: нет поля «vertices»',
    'строка 9, символ 1: это не JSON',
  ]);
});
