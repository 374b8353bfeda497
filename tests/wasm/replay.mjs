// Replays a trace with replay.wasm, as the page does, and compares the state at each step with the one that `vidno replay` writes.
//
//     node replay.mjs REPLAY.wasm TRACE STATES
import { deepStrictEqual } from 'node:assert';
import { readFileSync } from 'node:fs';
import { engineOf } from './engine.mjs';

const [module, traceFile, statesFile] = process.argv.slice(2);

const { wasm, made, opened } = engineOf(module);
const trace = opened(readFileSync(traceFile));
wasm.trace_header(trace);
const { method, scene } = JSON.parse(made());
const { x: left, y: top, width, height } = scene.window;

const isList = (value) => typeof value === 'object' && value !== null && 'rest' in value;

const isGroup = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Values after news about some of them, which may be groups of values. */
function after(old, news, hasGroups) {
  const entries = Object.entries(news).map(([key, value]) => {
    if (isList(value)) return [key, [...old[key].slice(0, value.from), ...value.rest]];
    return [key, hasGroups && isGroup(value) ? after(old[key] ?? {}, value, false) : value];
  });
  return { ...old, ...Object.fromEntries(entries) };
}

let values = {};
function goTo(step) {
  wasm.trace_values(trace, step);
  values = after(values, JSON.parse(made()), true);
}

const rows = (row) => Array.from({ length: height }, (_, j) => row(top + j));
const columns = (cell) => Array.from({ length: width }, (_, i) => cell(left + i));

/** A pixel as `#rrggbb`, whether it was painted or not. */
function color(pixel) {
  const [red, green, blue] = [pixel, pixel >> 8, pixel >> 16].map((byte) => byte & 0xff);
  return `#${((red << 16) | (green << 8) | blue).toString(16).padStart(6, '0')}`;
}

function picture() {
  const shown = rows((y) => {
    const pixels = new Uint32Array(wasm.memory.buffer, wasm.pixel_rows(trace, y, 1), width).slice();
    deepStrictEqual(columns((x) => wasm.pixel(trace, x, y) >>> 0), [...pixels]);
    deepStrictEqual([...pixels].map((pixel) => pixel >>> 24 !== 0), columns((x) => wasm.painter(trace, x, y) > 0));
    return [...pixels];
  });
  const repeats = shown.map((row, j) => j > 0 && row.every((pixel, i) => pixel === shown[j - 1][i]));
  deepStrictEqual(rows((y) => wasm.row_repeats(trace, y) !== 0), repeats);
  return shown.map((row) => row.map(color).join(''));
}

function depths() {
  if (!wasm.has_depths(trace)) return null;
  return rows((y) =>
    columns((x) => {
      wasm.depth_text(trace, x, y);
      return JSON.parse(made());
    }),
  );
}

const hasThreeLists = ['full', 'angles', 'vertex', 'edges'].some((name) => method === `warnock-${name}`);
const listOf = (window) => values.lists[window.list];

function warnock() {
  const { stack, current, clip, joined, last } = values.warnock;
  const others = {
    surrounding: joined.surrounding.map(({ polygon, level }) => [polygon, level]),
    outside: joined.outside.map(({ polygon, level }) => [polygon, level]),
  };
  return {
    stack: stack.map((each) => ({ window: each.window, apl: listOf(each) })),
    window: current?.window ?? null,
    apl: current === null ? null : listOf(current),
    ...last,
    clip,
    ...(hasThreeLists ? others : {}),
  };
}

function zbuffer() {
  const { polygon, edges, ael, last } = values.zbuffer;
  return { polygon, S: edges, ael, ...last, z: depths() };
}

function weilerAtherton() {
  const { lists, currentList, facets, visible } = values.weilerAtherton;
  const list = currentList && { pieces: currentList.pieces, inside: currentList.inside, outside: currentList.outside };
  return { lists, list, facets, visible };
}

function floatingHorizon() {
  const { curve, place, edges, horizons } = values.floatingHorizon;
  return {
    lines: values.lines.map(({ curve, from, to }) => [curve, from, to]),
    ...{ curve, ...place, leftEdge: edges.left, rightEdge: edges.right, ...horizons },
  };
}

/** The state in the form of `vidno replay`. */
function state() {
  const { step, calls } = values;
  if (method === 'floating-horizon') return { step, calls, ...floatingHorizon() };
  const begun = { step, calls, picture: picture() };
  if (method === 'zbuffer') return { ...begun, warnock: null, zbuffer: zbuffer() };
  if (method !== 'weiler-atherton') return { ...begun, warnock: warnock(), zbuffer: null };
  return { ...begun, warnock: null, zbuffer: null, weilerAtherton: weilerAtherton() };
}

const states = readFileSync(statesFile, 'utf8').trimEnd().split('\n');
deepStrictEqual(wasm.trace_length(trace), states.length - 1);

// Forward, then back and forth: multiples of a number that shares no divisor with the number of states visit all of them.
const greatestDivisor = (a, b) => (b === 0 ? a : greatestDivisor(b, a % b));
let stride = Math.floor(states.length * 0.382) + 1;
while (greatestDivisor(stride, states.length) > 1) stride++;
const order = [...states.keys(), ...[...states.keys()].map((n) => (n * stride) % states.length)];
for (const step of order) {
  goTo(step);
  deepStrictEqual(state(), JSON.parse(states[step]), `step ${step} of ${traceFile}`);
}
