import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import type { Language } from '../language/language.js';
import { imported, shown } from '../testing/moodle.js';
import type { Choice, Imported } from '../testing/moodle.js';
import { everyQuestion } from '../testing/questions.js';
import { headerOf, textOf, textWith, traceNames, traceOf } from '../testing/traces.js';
import { grade } from './grade.js';
import type { Answer } from './grade.js';
import { moodleXml, spread } from './moodle.js';
import { parts as forms } from './question.js';
import type { Part, Question } from './question.js';

const schema = fileURLToPath(new URL('../../test-data/moodle.rng', import.meta.url));

async function xmlOf(content: string, language: Language = 'en', count = 20): Promise<string> {
  return moodleXml(await traceOf(content), language, count) ?? '';
}

/** The questions of a file without its category. */
const questionsOf = (xml: string): readonly Imported[] => imported(xml).slice(1);

const rightOf = ({ options }: Choice): number =>
  options.findIndex(({ fraction }) => fraction === 100);

/** The choices that belong to each part: one; one for each option; or one for each place of a row or cell of a table. */
function choicesByPart(
  { parts }: Question,
  choices: readonly Choice[],
): readonly (readonly Choice[])[] {
  let from = 0;
  return parts.map(({ asks, options, right, given = [] }) => {
    const [form] = forms[asks];
    const isByGiven = asks === 'signs' || asks === 'cornerSigns';
    const places = isByGiven ? given.length : options.length;
    const length = { one: 1, some: places, row: places, table: right.length }[form];
    from += length;
    return choices.slice(from - length, from);
  });
}

/** The number that is right in a choice, or after it the nearest number that is wrong by its tolerance. */
function numberOf({ options }: Choice, place: number): string {
  const [value = NaN, tolerance = NaN] = options[0]?.html.split(':').map(Number) ?? [];
  return String(place === 0 ? value : value + 1.01 * tolerance);
}

/** The answer to a part that these options of its choices give. */
function valuesOf(
  { asks, options }: Part,
  chosen: readonly number[],
  choices: readonly Choice[],
): readonly string[] {
  const [form] = forms[asks];
  if (form === 'table') {
    return choices.map((choice, i) => numberOf(choice, chosen[i] ?? 0));
  }
  const value = (place: number): readonly string[] =>
    options.slice(place, place + 1).map((o) => o.value);
  if (form !== 'some') return chosen.flatMap(value);
  return options.filter((_, i) => chosen[i] === 0).map((option) => option.value);
}

/** Less detailed traces have nothing to ask about. */
const byTrace = traceNames.filter(
  (name) => !/zbuffer\.windows|horizon\.(windows|polygons)|atherton\.windows/u.test(name),
);

describe.each(byTrace)('the questions of %s for Moodle', (name) => {
  it('are well formed, and have the elements that Moodle requires', async () => {
    const input = await xmlOf(textOf(name), 'ru');
    const stdio = ['pipe', 'pipe', 'pipe'] as const;
    execFileSync('xmllint', ['--noout', '--relaxng', schema, '-'], { input, stdio: [...stdio] });
  });

  it('accept exactly the answer of the engine', async () => {
    const trace = await traceOf(textOf(name));
    const read = questionsOf(moodleXml(trace, 'en') ?? '');
    const asked = spread(trace, 20);
    expect(read).toHaveLength(asked.length);
    asked.forEach((question, n) => {
      const choices = choicesByPart(question, read[n]?.choices ?? []);
      const right = choices.map((each) => each.map(rightOf));
      const graded = (places: readonly (readonly number[])[]): readonly boolean[] => {
        const answer: Answer = question.parts.map((part, i) =>
          valuesOf(part, places[i] ?? [], choices[i] ?? []),
        );
        return grade(question, answer);
      };
      expect(graded(right)).not.toContain(false);
      choices.forEach((part, i) =>
        part.forEach(({ options }, j) => {
          const other = ((right[i]?.[j] ?? 0) + 1) % Math.max(2, options.length);
          const wrong = right.map((places, k) =>
            places.map((place, l) => (k === i && l === j ? other : place)),
          );
          expect(graded(wrong)[i]).toBe(false);
        }),
      );
    });
  });

  it('have one right option in each choice, and parts of equal weight', async () => {
    const trace = await traceOf(textOf(name));
    const read = questionsOf(moodleXml(trace, 'en') ?? '');
    spread(trace, 20).forEach((question, n) => {
      const choices = choicesByPart(question, read[n]?.choices ?? []);
      expect(choices.flat()).toHaveLength(read[n]?.choices.length ?? -1);
      for (const { options } of choices.flat()) {
        expect(options.map(({ fraction }) => fraction).sort((a, b) => b - a)).toEqual([
          100,
          ...options.slice(1).map(() => 0),
        ]);
        expect(new Set(options.map(({ html }) => html)).size).toBe(options.length);
      }
      const weights = choices.map((part) => part.reduce((sum, { weight }) => sum + weight, 0));
      expect(new Set(weights).size).toBe(1);
    });
  });
});

/** The question with this name, as the lines of text that a student reads. */
function linesOf(xml: string, name: RegExp): readonly string[] {
  const html = questionsOf(xml).find((each) => name.test(each.name))?.html ?? '';
  const lines = shown(html.replaceAll('</td><td>', '</td>: <td>').replaceAll('</th><td>', ': '));
  return lines.split('\n').filter(Boolean);
}

describe('a question for Moodle', () => {
  it('includes the data for its answer: the window, its list, the polygons', async () => {
    const xml = await xmlOf(textOf('small.warnock.signs.jsonl'));
    expect(linesOf(xml, /^Step 4: the case of a window$/)).toEqual([
      'The window (2, −1) 8 × 8 is examined. ProcessWindow sets hasSurround for a polygon only if it surrounds the window and the plane of no other is nearer at the four corners, not even where that other does not reach. Beside each polygon are the depths of its plane at the upper corners, left and right, and then at the lower ones.',
      'Area: (2, −1) 5 × 4',
      'Window: (2, −1) 8 × 8',
      'List of active polygons (APL): A, B',
      'Polygon A: (1, −2, 0.1) (8, −2, 0.1) (8, 4, 0.1) (1, 4, 0.1)',
      'Polygon B: (2.5, −0.5, 0.3) (6, 0, 0.4) (4, 2.5, 0.2)',
      'Which polygons stay in the window’s list? Only their boxes are tested.',
      'A',
      'B',
      'Which polygon is found to hide all others in this window?',
      'Which case does Warnock’s algorithm take?',
    ]);
  });

  it('includes the outlines of the walk, and the waiting lists', async () => {
    const lines = linesOf(await xmlOf(textOf('wall.weiler-atherton.signs.jsonl')), /the walk/);
    expect(lines.slice(0, 11)).toEqual([
      'RegionClip: walk round the part of Q inside W, from point 3, where the outline of Q enters. The points of that outline come first, then the other vertices of W, each in the order of the walk.',
      'Area: (0, 0) 16 × 16',
      'Current list: W: (2, 12) (2, 2) (14, 2) (14, 12); Q: (4, 14) (4, 6) (8, 6) (8, 14); S: (0, 16) (0, 0) (16, 0) (16, 16)',
      'Stack of lists: ∅',
      'Polygon W: (2, 2, 0.125) (14, 2, 0.875) (14, 12, 0.875) (2, 12, 0.125)',
      'Polygon Q: (4, 6, 0.75) (8, 6, 0.75) (8, 14, 0.75) (4, 14, 0.75)',
      'Polygon S: (0, 0, −0.5) (16, 0, −0.5) (16, 16, −0.5) (0, 16, −0.5)',
      'Which points follow, until the walk is back where it began? 1: (8, 14); 2: (4, 14); 3: (4, 12); 4: (4, 6); 5: (8, 6); 6: (8, 12); 7: (2, 12); 8: (2, 2); 9: (14, 2); 10: (14, 12)',
      '1.',
      '2.',
      '3.',
    ]);
  });

  it('shows the picture of its step, and explains its answer', async () => {
    const all = questionsOf(await xmlOf(textOf('small.warnock.signs.jsonl')));
    const first = all.find(({ name }) => name.startsWith('Step 4:'));
    expect(first?.files.map(({ name }) => name)).toEqual(['step-4.svg']);
    expect(first?.html).toContain('src="@@PLUGINFILE@@/step-4.svg"');
    expect(first?.files[0]?.content).toContain('· Step 4</title>');
    expect(
      shown(first?.feedback ?? '')
        .trim()
        .split('\n')
        .at(-1),
    ).toBe('Step 50: None of the simple cases: the window is split.');
  });

  it('shows names of polygons unchanged, whatever characters are in them', async () => {
    const id =
      ']]>{1:SHORTANSWER:=x}~=%100%#\\</text><script>alert("\'")</script>&amp;@@PLUGINFILE@@$$x$$';
    const hostile = textOf('small.warnock.signs.jsonl').replaceAll('"A"', () => JSON.stringify(id));
    const plain = questionsOf(await xmlOf(textOf('small.warnock.signs.jsonl')));
    const read = questionsOf(await xmlOf(hostile));
    const inside = ({ html, choices, feedback }: Imported): readonly string[] =>
      [html, feedback, ...choices.flatMap(({ options }) => options.map((o) => o.html))].map(shown);
    expect(read.map(inside).flat().join('\n')).toContain(`Polygon ${id}`);
    expect(read.map((each) => each.choices.map(rightOf))).toEqual(
      plain.map((each) => each.choices.map(rightOf)),
    );
    expect(read.map(({ html }) => html).join('')).not.toMatch(/<script|[{}]|\$\$/);
  });
});

describe('a file of questions for Moodle', () => {
  it('is in the language that was chosen', async () => {
    const xml = await xmlOf(textOf('small.warnock.signs.jsonl'), 'ru');
    const [category] = imported(xml);
    expect(category?.name).toBe(
      '$course$/top/vidno · A square, a triangle and a slope · Алгоритм Варнока · double · исправленный текст',
    );
    expect(linesOf(xml, /^Шаг 4: случай окна$/)[0]).toMatch(
      /^Рассматривается окно \(2; −1\) 8 × 8\./,
    );
  });

  it('has the same bytes each time', async () => {
    const text = textOf('small.warnock.signs.jsonl');
    expect(await xmlOf(text)).toBe(await xmlOf(text));
  });

  it('has the requested number of questions, of all kinds, up to the end of the run', async () => {
    const trace = await traceOf(textOf('small.warnock.signs.jsonl'));
    const questions = spread(trace, 12);
    const steps = questions.map(({ step }) => step);
    expect(questionsOf(moodleXml(trace, 'en', 12) ?? '')).toHaveLength(12);
    expect(steps).toEqual([...steps].sort((a, b) => a - b));
    expect(steps.at(-1)).toBeGreaterThan(trace.timeline.length / 2);
    const found = everyQuestion(trace).map(({ kind }) => kind);
    expect(new Set(questions.map(({ kind }) => kind))).toEqual(new Set(found));
  });

  it('puts a run into one category, even if there is a slash in its name', async () => {
    const text = textOf('small.warnock.signs.jsonl').replace('A square, a triangle', 'In/Out');
    expect(imported(await xmlOf(text))[0]?.name).toContain('vidno · In//Out and a slope');
  });

  it('does not exist for a run without questions', async () => {
    const coarse = await traceOf(textOf('small.zbuffer.windows.jsonl'));
    expect(moodleXml(coarse, 'en')).toBeNull();
    expect(moodleXml(await traceOf(textWith(headerOf('warnock'), [])), 'en')).toBeNull();
  });
});
