// Traces every run of every lesson, and the teapot, for the page: node lessons/trace.mjs VIDNO DIRECTORY
// A trace that is younger than its scene and the program is kept.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [program, directory] = process.argv.slice(2);
const lessons = import.meta.dirname ?? new URL('.', import.meta.url).pathname;
const kept = new Set(['index.json']);
let done = 0;

const time = (file) => (existsSync(file) ? statSync(file).mtimeMs : -1);

/** Runs the program unless what it would write is up to date. */
function make(file, source, args) {
  kept.add(file);
  const output = join(directory, file);
  if (time(output) > Math.max(time(source), time(program))) return;
  console.log(`  ${file}`);
  execFileSync(program, [...args, '-o', output], { stdio: ['ignore', 'inherit', 'inherit'] });
  done += 1;
}

function trace(id, scene, { method, kernel, edition, detail }) {
  const file = `${id}.${method}.${kernel}.${edition}.${detail}.jsonl.gz`;
  const options = ['--method', method, '--kernel', kernel, '--edition', edition, '--detail', detail];
  make(file, scene, ['trace', scene, ...options]);
  return { file, method, kernel, edition, detail };
}

function lesson(id) {
  const { title, runs } = JSON.parse(readFileSync(join(lessons, id, 'lesson.json'), 'utf8'));
  const traces = runs.map(({ scene = 'scene.json', ...run }) => {
    const name = scene === 'scene.json' ? id : `${id}.${scene.replace(/\.json$/, '')}`;
    return trace(name, join(lessons, id, scene), run);
  });
  return { id, title, traces };
}

function teapot() {
  const mesh = join(lessons, 'meshes', 'teapot.obj');
  make('teapot.json', mesh, ['import', mesh]);
  const run = { kernel: 'double', edition: 'corrected', detail: 'windows' };
  const scene = join(directory, 'teapot.json');
  const traces = ['warnock', 'zbuffer'].map((method) => trace('teapot', scene, { method, ...run }));
  return { id: 'teapot', title: { en: 'A real mesh: the Utah teapot', ru: 'Настоящая сетка: чайник из Юты' }, traces };
}

mkdirSync(directory, { recursive: true });
const ids = readdirSync(lessons).filter((name) => existsSync(join(lessons, name, 'lesson.json')));
const index = JSON.stringify([...ids.sort().map(lesson), teapot()], null, 1);

for (const file of readdirSync(directory)) {
  if (!kept.has(file)) rmSync(join(directory, file));
}
const file = join(directory, 'index.json');
if (!existsSync(file) || readFileSync(file, 'utf8') !== index) {
  writeFileSync(`${file}.new`, index);
  renameSync(`${file}.new`, file);
}
console.log(`  ${kept.size - 1} files, ${done} of them new`);
