// Writes the tables of the atlas, README.md and README.ru.md, and why its wrong pictures have no proof, unproved.jsonl:
// node lessons/failures/table.mjs VIDNO
// With --check it writes nothing, and exits with 1 if a file is not what it would write.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [program, mode] = process.argv.slice(2);
const folder = import.meta.dirname ?? new URL('.', import.meta.url).pathname;
const work = mkdtempSync(join(tmpdir(), 'vidno-failures-'));

const comma = (number) => String(number).replace('.', ',');

/** An answer: yes or no, a number, or a half-open range. */
const answer = (value, { yes, no, none, range }) => {
  if (typeof value === 'boolean') return value ? yes : no;
  if (typeof value === 'number') return String(value).replace('-', '−');
  const [first, end] = value;
  if (end - first === 1) return String(first);
  return first < end ? range(first, end - 1) : none;
};

/** What a decision is about, in each language. The build makes this table. */
const eventTable = readFileSync(join(folder, '../../viewer_web/src/trace/event-table.ts'), 'utf8');
const decisions = Function(`return ${eventTable.match(/const decisionWords\b.*? = (\{.*?\n\})/su)[1]}`)();

const english = { yes: 'yes', no: 'no', none: 'none', range: (first, last) => `${first} to ${last}` };
const russian = { yes: 'да', no: 'нет', none: 'пусто', range: (first, last) => `от ${first} до ${last}` };

const words = {
  en: {
    file: 'README.md',
    title: '# How these methods fail',
    introduction: `Each entry is a file with the smallest known scene, the run that fails on it, a run that does not (perhaps of the same surface with
other samples), and the place where the failure is visible. \`tests/check/failures_test.cpp\` checks each entry. The column *at step*
counts the events of a trace of level \`signs\` up to the first wrong decision or the first visibly wrong step. \`table.mjs\` writes
these tables, and in \`unproved.jsonl\` why a wrong picture has no proof. The page shows that, too.`,
    head: ['failure', 'how', 'seen under', 'at step', 'there', 'remedy'],
    wrong: ({ of, taken, exact }) => `${decisions.en[of]}: computed ${answer(taken, english)}, exact ${answer(exact, english)}`,
    pixel: ([shown, right]) => `${shown ?? 'the background'} is painted, not ${right ?? 'the background'}`,
    fault: ({ en }) => en,
    endless: () => 'it does not end by itself',
    missing: (label) => `${label} is not reached`,
    present: (label) => `${label} is reached`,
    windows: ([more, fewer]) => `${more} windows, not ${fewer}`,
    off: ([x, right]) => `an intersection at x = ${x}, not ${right}`,
    column: ([curve, x, drawn]) => `curve ${curve} is ${drawn ? 'drawn' : 'not drawn'} over column ${x}`,
    place: ([curve, x, drawn]) => `curve ${curve} is ${drawn ? 'drawn' : 'not drawn'} at x = ${x}`,
    test: 'a test of its own',
    unproved: (pixel, painted) => `Pixel ${pixel}: ${painted ?? 'the background'} is painted, but `,
    more: (count) => (count === 1 ? 'One more pixel is wrong.' : `${count} more pixels are wrong.`),
  },
  ru: {
    file: 'README.ru.md',
    title: '# Как ошибаются эти методы',
    introduction: `Запись — это файл. В нём наименьшая известная сцена, прогон, который на ней ошибается, прогон, который не ошибается (иногда
на той же поверхности с другими отсчётами), и место, где ошибка видна. \`tests/check/failures_test.cpp\` проверяет каждую
запись. Шаг — это шаг трассы уровня \`signs\`: первое неверное решение или первый шаг, на котором ошибка видна. Таблицы пишет
\`table.mjs\`. Он пишет и \`unproved.jsonl\`: почему у неверного изображения нет доказательства. Страница это показывает.`,
    head: ['ошибка', 'причина', 'прогон', 'шаг', 'что на нём видно', 'исправление'],
    wrong: ({ of, taken, exact }) => `${decisions.ru[of]}: вычислено ${answer(taken, russian)}, точный ответ — ${answer(exact, russian)}`,
    pixel: ([shown, right]) => `закрашен ${shown ?? 'фон'}, а не ${right ?? 'фон'}`,
    fault: ({ ru }) => ru,
    endless: () => 'сам не завершается',
    missing: (label) => `строка ${label} не достигнута`,
    present: (label) => `строка ${label} достигнута`,
    windows: ([more, fewer]) => `окон ${more}, а не ${fewer}`,
    off: ([x, right]) => `пересечение при x = ${comma(x)}, а не ${comma(right)}`,
    column: ([curve, x, drawn]) => `кривая ${curve} над столбцом ${x} ${drawn ? 'нарисована' : 'не нарисована'}`,
    place: ([curve, x, drawn]) => `кривая ${curve} при x = ${comma(x)} ${drawn ? 'нарисована' : 'не нарисована'}`,
    test: 'отдельный тест',
    unproved: (pixel, painted) => `Пиксель ${pixel}: закрашен ${painted ?? 'фон'}, но `,
    more: (count) => (count === 1 ? 'Неверен ещё один пиксель.' : `Других неверных пикселей: ${count}.`),
  },
};

function vidno(...args) {
  const { status, stdout, stderr } = spawnSync(program, args, { encoding: 'utf8' });
  if (status === 2) throw new Error(stderr);
  return stdout;
}

/** The file of a scene, for the program. */
function written(scene, name) {
  const file = join(work, name);
  writeFileSync(file, JSON.stringify(scene));
  return file;
}

const traceFile = (name) => join(work, `${name}.jsonl`);

function trace(name, scene, { method, kernel, edition }, ...more) {
  const file = traceFile(name);
  const run = ['--method', method, '--kernel', kernel, '--edition', edition, ...more];
  vidno('trace', scene, ...run, '--max-events', '20000', '-o', file); // one of them goes on for millions
  return readFileSync(file, 'utf8').split('\n').slice(1, -2).map((line) => JSON.parse(line));
}

/** The reason of a fault in each language; the sentence of its step has the Russian one. */
function reasons(name, step, reason) {
  const sentence = vidno('say', traceFile(name), '--step', step, '--language', 'ru');
  return { en: reason, ru: sentence.match(/ошибается: ([^.]+)\./u)[1] };
}

const place = (events, label) => events.findIndex(({ e, at }) => at === label && e !== 'call');
const count = (events, name) => events.filter(({ e }) => e === name).length;

/** The step that painted a pixel last, and the polygon. */
function painting({ polygons }, events, [x, y]) {
  const inRuns = (row, runs) => row === y && runs.some(([first, end]) => first <= x && x < end);
  const inRectangle = ([left, top, width, height]) => left <= x && x < left + width && top <= y && y < top + height;
  const paints = {
    fill: ({ rect }) => inRectangle(rect),
    draw: ({ runs }) => runs.some(([row, ...run]) => inRuns(row, [run])),
    span: ({ row, runs }) => inRuns(row, runs),
  };
  let last = { step: '' };
  let scanned = '';
  events.forEach((event, i) => {
    if (event.e === 'polygon') scanned = event.color;
    if (!paints[event.e]?.(event)) return;
    const color = event.color ?? scanned;
    last = { step: i + 1, id: polygons.find((polygon) => polygon.color === color)?.id };
  });
  return last;
}

/** The intersection that differs most between the two runs, compared in their order. */
function farthestCut(failing, holding) {
  const cuts = (events) => events.flatMap(({ e, vertex }, i) => (e === 'clip_cross' ? [{ step: i + 1, x: vertex[0] }] : []));
  const right = cuts(holding);
  const pairs = cuts(failing).map(({ step, x }, i) => ({ step, there: 'off', value: [x, right[i].x] }));
  const far = ({ value: [x, there] }) => Math.abs(x - there);
  return pairs.reduce((farthest, pair) => (far(pair) > far(farthest) ? pair : farthest));
}

const overColumn = ({ fromColumns, toColumns }, x) => fromColumns[1] <= x && x <= toColumns[0];

/** A number of a trace, perhaps a fraction. */
const numberOf = (value) => {
  const [above, below = 1] = String(value).split('/').map(Number);
  return above / below;
};
const overPlace = ({ from, to }, x) => numberOf(from[0]) <= x && x <= numberOf(to[0]);

/** The step that draws a curve over a column or a place or, if none does, the last that examines its segment there. */
function drawing(events, [curve, x], there, over) {
  const begin = events.findIndex((event) => event.e === 'curve' && event.curve === curve);
  const end = events.findIndex((event, i) => i > begin && event.e === 'curve');
  const steps = events
    .map((event, i) => ({ event, step: i + 1 }))
    .slice(begin, end < 0 ? undefined : end);
  const drawn = steps.find(({ event }) => event.e === 'draw_line' && over(event, x));
  const looked = steps.findLast(({ event: { e, segment } }) => e === 'visibility' && segment[0] <= x && x <= segment[1]);
  return { step: (drawn ?? looked).step, there, value: [curve, x, drawn !== undefined] };
}

/** Where the failure is seen. */
function seen({ scene, fails, holds, shows }) {
  const file = written(scene, 'scene.json');
  const failing = trace('fails', file, fails);
  const holding = trace('holds', holds.scene ? written(holds.scene, 'holds.json') : file, holds);
  if (shows.fault) {
    const step = failing.findIndex(({ e, at }) => e === 'fault' && at === shows.fault) + 1;
    return step === 0 ? { there: 'endless' } : { step, there: 'fault', value: reasons('fails', step, failing[step - 1].reason) };
  }
  if (shows.missing) return { step: place(holding, shows.missing) + 1, there: 'missing', value: shows.missing };
  if (shows.present) return { step: place(failing, shows.present) + 1, there: 'present', value: shows.present };
  if (shows.more_windows) return { there: 'windows', value: [failing, holding].map((events) => count(events, 'pop')) };
  if (shows.off) return farthestCut(failing, holding);
  const checked = trace('checked', file, fails, '--check');
  const wrong = checked.findIndex(({ e }) => e === 'disagree');
  if (fails.edition === 'corrected' && wrong >= 0) return { step: wrong, there: 'wrong', value: checked[wrong] };
  if (shows.column) return drawing(failing, shows.column, 'column', overColumn);
  if (shows.place) return drawing(failing, shows.place, 'place', overPlace);
  const painted = painting(scene, failing, shows.pixel);
  return { step: painted.step, there: 'pixel', value: [painted.id, painting(scene, holding, shows.pixel).id] };
}

/** The sentences about a pixel: first what shows there. The last line, about the run, is left out. */
function reasonsAt(file, pixel, language) {
  const [first, ...others] = vidno('why', file, `--pixel=${pixel}`, '--language', language).trimEnd().split('\n');
  return [first.replace(/^.*?: /u, ''), ...others.filter((line) => line.startsWith('  ')).map((line) => line.trim())];
}

const withStop = (sentence) => sentence.replace(/\.?$/u, '.');
const capital = (sentence) => sentence[0].toUpperCase() + sentence.slice(1);

/** Why the picture of an entry has no proof: what is so at the pixel that the entry shows, or at the first wrong one. */
function unproved({ name, entry: { scene, shows } }) {
  const file = join(folder, `${name}.json`);
  const wrong = vidno('prove', file, '-o', join(work, 'proof.jsonl')).trimEnd().split('\n').filter((line) => line !== '');
  if (wrong.length === 0) return [];
  const line = wrong.find((each) => each.startsWith(`pixel ${shows.pixel} `)) ?? wrong[0];
  const [, pixel, color] = /^pixel (\S+) is (#\w+)/u.exec(line);
  const painted = scene.polygons.find((polygon) => polygon.color === color)?.id;
  const english = reasonsAt(file, pixel, 'en');
  const told = Object.entries(words).map(([language, { unproved: but, more }]) => {
    const [shown, ...others] = reasonsAt(file, pixel, language);
    // `prove` names the polygons in the colour of the pixel, besides the one that shows.
    const sentences = others.filter((_, i) => line.includes(`. ${english[i + 1]}`)).map((each) => withStop(capital(each)));
    const rest = wrong.length > 1 ? [more(wrong.length - 1)] : [];
    return [language, [withStop(but(pixel, painted) + shown), ...sentences, ...rest].join(' ')];
  });
  return [JSON.stringify({ name, ...Object.fromEntries(told) })];
}

function row(language, { name, entry, found }) {
  const { title, why, remedy, fails, source } = entry;
  const text = words[language];
  const run = fails ? `${fails.method}, ${fails.kernel}${fails.edition === 'corrected' ? '' : `, ${fails.edition}`}` : text.test;
  const there = found ? text[found.there](found.value) : '';
  const because = why[language] + (source ? ` (${source})` : '');
  return [`[${title[language]}](${name}.json)`, because, run, found?.step ?? '', there, remedy[language]];
}

function table(language, entries) {
  const { title, introduction, head } = words[language];
  const lines = [head, head.map(() => '---'), ...entries.map((each) => row(language, each))];
  const cells = lines.map((line) => `| ${line.map((cell) => String(cell).replaceAll('|', '\\|')).join(' | ')} |`);
  return `${title}\n\n${introduction}\n\n${cells.join('\n')}\n`;
}

try {
  const entries = readdirSync(folder)
    .filter((file) => file.endsWith('.json'))
    .sort()
    .map((file) => {
      const entry = JSON.parse(readFileSync(join(folder, file), 'utf8'));
      return { name: file.replace(/\.json$/u, ''), entry, found: entry.scene && seen(entry) };
    });
  const pictures = entries.filter(({ entry }) => entry.scene?.polygons !== undefined);
  const files = Object.entries(words).map(([language, { file }]) => [file, table(language, entries)]);
  files.push(['unproved.jsonl', pictures.flatMap(unproved).map((line) => `${line}\n`).join('')]);
  for (const [file, written] of files) {
    const path = join(folder, file);
    if (mode !== '--check') writeFileSync(path, written);
    else if (readFileSync(path, 'utf8') !== written) {
      console.error(`${path} is not what table.mjs writes`);
      process.exitCode = 1;
    }
  }
} finally {
  rmSync(work, { recursive: true });
}
