import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import { refusalOf, whyRefused } from './refusal.js';
import { addPolygon, emptySketch } from './sketch.js';

const drawn = addPolygon(emptySketch, [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
]);

it.each([
  ['scene: /polygons/0/vertices: not convex', 'A', 'not convex'],
  ['scene: /polygons/0/vertices/1/2: z outside -1 to 1\n', 'A', 'z outside -1 to 1'],
  ['scene: /window/width: not from 1 to 16384', '/window/width', 'not from 1 to 16384'],
  ['scene: line 2, column 3: not valid JSON', null, 'line 2, column 3: not valid JSON'],
  ['scene: /polygons/7: twice', '/polygons/7', 'twice'],
  ['scene: polygon my face has no area', 'my face', 'has no area'],
  [
    'scene: polygon A has a vertex of polygon B before it: its body is not convex, or it goes round the other way',
    'A',
    'has a vertex of another one before it: its body is not convex, or it goes round the other way',
  ],
])('%s', (message, polygon, reason) => {
  expect(refusalOf(message, drawn)).toEqual({ polygon, reason });
});

it('is said in the language of the page, with what it is about', () => {
  const said = whyRefused('scene: /function: rint: no such function', drawn, texts.ru.scene);
  expect(said).toBe('Формула: rint: такой функции нет');
  const message = 'scene: /function: not finite at x = 0, z = 0.5';
  expect(languages.map((each) => whyRefused(message, drawn, texts[each].scene))).toEqual([
    'The formula is not finite at x = 0, z = 0.5',
    'Значение формулы не конечно при x = 0, z = 0,5',
  ]);
});
