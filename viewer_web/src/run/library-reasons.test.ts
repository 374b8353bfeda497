import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { inWordsOf } from './refusal.js';

const sources = [
  'format/trace_header.cpp',
  'format/event_reader.cpp',
  'format/tree_event.cpp',
  'replay/screen.cpp',
  'replay/warnock_state.cpp',
  'replay/z_buffer_state.cpp',
  'replay/weiler_atherton_state.cpp',
  'replay/floating_horizon_state.cpp',
  'json/json_node.cpp',
  'scene/scene_json.cpp',
  'scene/surface.cpp',
  'scene/failure.cpp',
  'import/obj.cpp',
  'import/off.cpp',
  'import/ply.cpp',
  'import/stl.cpp',
  'import/mesh_soup.cpp',
];

/** The reasons that a source of the library gives as they stand. */
function reasonsIn(source: string): readonly string[] {
  const path = fileURLToPath(new URL(`../../../trace/${source}`, import.meta.url));
  const literals = readFileSync(path, 'utf8').matchAll(
    /(?:refuse\(|Refused\(|Impossible\{|place_among\(\w+, |reason = |left_out\.add\(|leave_out\()("(?:[^"\\]|\\.)*")[),}]/gu,
  );
  return [...literals]
    .map(([, literal = '""']) => JSON.parse(literal) as string)
    .filter((reason) => !reason.includes('this command'));
}

const inRussian = (reason: string): string =>
  inWordsOf({ line: null, column: null, place: '', reason }, texts.ru.scene);

it.each(sources)('each reason of %s is given in Russian', (source) => {
  const reasons = reasonsIn(source);
  expect(reasons.length).toBeGreaterThan(1);
  expect(reasons.filter((reason) => !/\p{Script=Cyrillic}/u.test(inRussian(reason)))).toEqual([]);
});

it('the reason for an unknown word is given in Russian', () => {
  expect(reasonsIn('json/json_node.h').map(inRussian)).toEqual(['неизвестное слово']);
});

it('a file of another version is refused in the words of its reader', () => {
  const reason = 'not "vidno-scene/1" but "vidno-scene/2": a newer vidno reads this file';
  const fault = { line: 1, column: 12, place: '/format', reason };
  expect(inWordsOf(fault, texts.ru.scene)).toBe(
    'строка 1, символ 12: /format: не "vidno-scene/1", а "vidno-scene/2": этот файл читает более новая версия vidno',
  );
  expect(texts.en.reasons.newerFormat('vidno-scene/1', 'vidno-scene/2')).toBe(reason);
});
