import { readFileSync } from 'node:fs' // node verify.mjs SCENE.json PICTURE.png PROOF.jsonl: checks a proof, see trace/PROOF.md
import { readPicture } from './read_picture.mjs'
const check = (isTrue, reason) => isTrue || (console.error(reason), process.exit(1))
const value = ([a, b, c], [x, y]) => a * x + b * y + c
const contains = (a, b) => [0, 1].every(i => a[i] <= b[i] && b[i + 2] > 0 && b[i] + b[i + 2] <= a[i] + a[i + 2])
const exact = (x, power = 1074n) => x % 1 ? exact(x * 2, power - 1n) : BigInt(x) << power // a double in units of 2^-1074
function polygon({ vertices }) {
  const v = vertices.map(vertex => vertex.map(number => exact(number))), pairs = v.map((p, i) => [p, v[(i + 1) % v.length]])
  const sum = (i, k) => pairs.reduce((area, [p, q]) => area + p[i] * q[k] - p[k] * q[i], 0n) // Newell's
  const way = sum(0, 1) > 0n ? 1n : -1n, [a, b, c] = [way * sum(1, 2), way * sum(2, 0), way * sum(0, 1)]
  const edges = pairs.map(([p, q]) => [way * (p[1] - q[1]), way * (q[0] - p[0]), way * (p[0] * q[1] - p[1] * q[0])]) // >= 0 inside
  check(edges.every(edge => v.every(vertex => value(edge, vertex) >= 0n)), 'scene: a polygon is not convex')
  return { edges, c, depth: [-a, -b, c * v[0][2] + a * v[0][0] + b * v[0][1]] } // value / c is its depth; c = 0: edge-on
}
const holds = ({ edges, c }, places) => c > 0n && edges.every(edge => places.every(at => value(edge, at) >= 0n))
const gap = (p, q, at) => value(polygons[q].depth, at) * polygons[p].c - value(polygons[p].depth, at) * polygons[q].c
const [sceneText, proof] = [process.argv[2], process.argv[4]].map(file => readFileSync(file))
const scene = JSON.parse(sceneText), polygons = scene.polygons.map(polygon), { x: left, y: top, width, height } = scene.window
const [header, ...lines] = proof.toString().trimEnd().split('\n').map(line => JSON.parse(line)), proved = []
const pixels = readPicture(process.argv[3], width, height)
check(pixels.length === 3 * width * height && !scene.camera && header.format === 'vidno-proof/1', 'no scene, picture and proof')
let around = [{ outer: [left, top, width, height], leftOut: [] }]
for (const [i, { rectangle, edge_on = [], beside = [], behind = [], owner }] of lines.entries()) {
  const [x, y, w, h] = rectangle, line = `line ${i + 2}:`, holding = [...behind.map(([, q]) => q), owner ?? []].flat()
  const corners = [[x, y], [x + w - 1, y], [x, y + h - 1], [x + w - 1, y + h - 1]].map(at => at.map(k => exact(k + 0.5)))
  check((around = around.filter(({ outer }) => contains(outer, rectangle))).length > 0, `${line} not in the window`)
  for (const p of edge_on) check(polygons[p].c === 0n, `${line} ${p} is not edge-on`)
  for (const [p, e] of beside) check(corners.every(at => value(polygons[p].edges[e], at) < 0n), `${line} ${p} is not beside`)
  for (const [p, q] of behind) check(corners.every(at => gap(p, q, at) >= (q < p ? 0 : 1)), `${line} ${p} is not behind ${q}`)
  for (const p of holding) check(holds(polygons[p], corners), `${line} ${p} does not hold the rectangle`)
  const leftOut = new Set([...around.at(-1).leftOut, ...edge_on, ...[...beside, ...behind].map(([p]) => p)])
  around.push({ outer: rectangle, leftOut })
  if (owner === undefined) continue
  check(polygons.every((_, p) => p === owner || leftOut.has(p)), `${line} another polygon has no reason`)
  const color = (owner === null ? scene.background : scene.polygons[owner].color).slice(1).toLowerCase()
  for (let k = 0; k < w * h; ++k) (proved[(y - top + Math.floor(k / w)) * width + x - left + (k % w)] ??= []).push(color)
}
for (let k = 0; k < width * height; ++k)
  check(proved[k]?.join() === pixels.toString('hex', 3 * k, 3 * k + 3), `pixel ${k}: not proved once, or not in this colour`)
console.log(`proved: the picture shows the scene at each of its ${width * height} pixels`)
