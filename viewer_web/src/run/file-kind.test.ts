import { expect, it } from 'vitest';
import { isMesh, kindOf } from './file-kind.js';

it.each([
  ['{"format":"vidno-scene/1","window":{}', 'scene'],
  ['{\n  "name": "a: {\\"b",\n  "polygons": [', 'scene'],
  ['{"curves": [[[0, 1], [1, 2]]]}', 'scene'],
  ['{"function": "x"', 'scene'],
  ['{\n  "format": "vidno-failure/1",\n  "scene": {"format": "vidno-scene/1"}', 'failure'],
  ['{"title": {"polygons": 1}, "fails": {}}', 'failure'],
  ['{"format": "vidno-chart/1", "curves": []}', 'chart'],
  ['{"format":"vidno-trace/1","method":"warnock","scene":{"format":"vidno-scene/1"}}\n', 'trace'],
  // The reader of a file reports that it is of another version.
  ['{"format":"vidno-scene/2","polygons":[]}', 'scene'],
  ['{"format":"vidno-surface/2"}', 'scene'],
  ['{"format":"vidno-failure/2"}', 'failure'],
  ['{"format":"vidno-chart/2"}', 'chart'],
  ['{"format":"vidno-trace/2"}\n', 'trace'],
  // The library reports the error and its place.
  ['{\n  "windw": {"x": 0},\n  "background": "white"\n}', 'scene'],
  ['{\n  "polygons": [\n    {"vertices" [[0', 'scene'],
  ['{"format":"vidno-scene/1","polygons":[', 'scene'],
  // A file that is not a scene is reported as a trace, line by line.
  ['{"e":"push","at":"W3"}\n{"e":"pop"}\n', 'trace'],
  // Only the program reads meshes, whatever their files are named.
  ['ply\nformat ascii 1.0\n', 'mesh'],
  ['solid cube\n  facet normal 0 0 1\n', 'mesh'],
  ['OFF\n8 6 12\n', 'mesh'],
  ['# a cube\nmtllib cube.mtl\no Cube\nv 0 0 -1.5\n', 'mesh'],
  ['v 1 2 3\nv 2 2 2\n', 'mesh'],
  ['office\n', 'trace'],
  ['hello', 'trace'],
  ['', 'trace'],
  ['[1, 2]', 'trace'],
])('%s', (start, kind) => {
  expect(kindOf(start)).toBe(kind);
});

it.each(['cube.obj', 'cube.OFF', 'a b.ply', 'part.Stl'])('%s is a mesh', (name) => {
  expect(isMesh(name)).toBe(true);
});

it.each(['scene.json', 'run.jsonl.gz', 'obj', 'object.objx', 'cube.obj.gz'])(
  '%s is no mesh',
  (name) => {
    expect(isMesh(name)).toBe(false);
  },
);
