import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { glossary, wordsLike } from '../i18n/glossary.js';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { excerpt } from '../listing/listings.js';

const folder = fileURLToPath(new URL('../../../lessons/', import.meta.url));
const ids = readdirSync(folder)
  .filter((name) => /^\d\d-/.test(name))
  .sort();
const storyOf = (id: string, language: Language): string =>
  readFileSync(`${folder}${id}/story.${language}.md`, 'utf8');

interface Frame {
  readonly minutes: number;
  readonly prerequisites: readonly string[];
  readonly sources: readonly { readonly key: string }[];
}
const readLesson = (id: string): Frame =>
  JSON.parse(readFileSync(`${folder}${id}/lesson.json`, 'utf8')) as Frame;

/** A session is a choice of lists of lessons. */
interface Plan {
  readonly hours: number;
  readonly sessions: readonly (readonly (readonly string[])[])[];
}

/** The lessons that must come before this one, directly or not. */
const allBefore = (id: string): readonly string[] =>
  readLesson(id).prerequisites.flatMap((each) => [each, ...allBefore(each)]);

describe('the course plans', () => {
  const plans = JSON.parse(readFileSync(`${folder}plans.json`, 'utf8')) as readonly Plan[];
  const [minutesOfHour, minutesOfSession] = [45, 90];

  it('are the document that readers see: after a change, run ./dev derive', () => {
    const program =
      'const { coursePage, readPlans } = await import("./course.mjs"); process.stdout.write(coursePage(readPlans()))';
    const page = execFileSync('node', ['--input-type=module', '-e', program], {
      cwd: folder,
      encoding: 'utf8',
    });
    expect(readFileSync(`${folder}COURSE.md`, 'utf8')).toBe(page);
  });

  it('fill 4, 8 and 12 hours with sessions of two hours that have time for their lessons', () => {
    expect(plans.map(({ hours }) => hours)).toEqual([4, 8, 12]);
    for (const { hours, sessions } of plans) {
      expect(sessions.length * minutesOfSession).toBe(hours * minutesOfHour);
      for (const lessons of sessions.flat()) {
        const minutes = lessons.map((id) => readLesson(id).minutes);
        const all = minutes.reduce((sum, each) => sum + each, 0);
        expect(all, lessons.join()).toBeLessThanOrEqual(minutesOfSession);
      }
    }
  });

  it('have each lesson once, after those that must come first', () => {
    for (const { sessions } of plans) {
      const done = new Set<string>();
      for (const alternatives of sessions)
        for (const lessons of alternatives)
          for (const lesson of lessons) {
            expect(done).not.toContain(lesson);
            expect([...done]).toEqual(expect.arrayContaining([...allBefore(lesson)]));
            done.add(lesson);
          }
    }
  });
});

describe('the minutes of a lesson', () => {
  /** The estimate that COURSE.md explains. */
  function estimate(story: string): number {
    const [text = '', questions = ''] = story.split(/^## (?:Questions|Exercises)$/m);
    const words = text.replace(/^ *```[^]*?^ *```$/gm, '').match(/[\p{L}\p{N}_]+/gu)?.length ?? 0;
    const steps = new Set([...text.matchAll(/\(#([-\w]+)\)/g)].map(([, pin]) => pin)).size;
    const asked = questions.match(/^\d+\. /gm)?.length ?? 0;
    return 5 * Math.round((words / 100 + steps / 2 + 2 * asked) / 5);
  }

  it('are estimated from its words, the steps that it shows, and its questions', () => {
    expect(
      estimate(`${'word '.repeat(1000)}[a](#a) [b](#b) [a](#a)\n\n## Questions\n\n1. Why?\n`),
    ).toBe(15);
    for (const id of ids)
      expect([id, readLesson(id).minutes]).toEqual([id, estimate(storyOf(id, 'en'))]);
  });
});

describe('the sources', () => {
  it('are each used by a lesson', () => {
    const listed = JSON.parse(readFileSync(`${folder}sources.json`, 'utf8')) as object;
    const used = ids.flatMap((id) => readLesson(id).sources.map(({ key }) => key));
    expect([...new Set(used)].sort()).toEqual(Object.keys(listed).sort());
  });
});

/** The running text of a story: no title, goals, headings, fences, code, formulas or addresses of links. */
function runningText(story: string): string {
  return story
    .replace(/^# .*\n+(?:- .*\n(?: {2}.*\n)*)*/, '')
    .replace(/^ *```[^]*?^ *```$/gm, '')
    .replace(/^#+ .*$/gm, '')
    .replace(/\$?`[^`]*`\$?/g, '§')
    .replace(/\]\([^)]*\)/g, ']')
    .replace(/\s+/g, ' ');
}

/** Where a term first occurs in the lessons, unless it stands there in bold. */
function firstUse(texts: readonly string[], forms: readonly string[]): string | null {
  for (const [i, text] of texts.entries()) {
    const found = text.toLowerCase().search(wordsLike(forms));
    if (found < 0) continue;
    const isBold = (text.slice(0, found).split('**').length - 1) % 2 === 1;
    return isBold ? null : `${String(ids[i])}: ${text.slice(Math.max(0, found - 40), found + 40)}`;
  }
  return 'nowhere';
}

describe('the terms of the glossary', () => {
  it.each(languages)('stand in bold where the course first uses them, in %s', (language) => {
    const texts = ids.map((id) => runningText(storyOf(id, language)));
    const early = glossary.map((entry) => [entry.en.term, firstUse(texts, entry[language].find)]);
    expect(early.filter(([, use]) => use !== null)).toEqual([]);
  });

  it('would be caught: a term before its definition, and one without', () => {
    const texts = [
      '# A window\n\n- see a window\n\nThe depth.\n',
      'A **depth** of a **window**.\n',
    ];
    const running = texts.map(runningText);
    expect(firstUse(running, ['depth*'])).toContain('The depth.');
    expect(firstUse(running, ['window'])).toBe(null);
    expect(firstUse(running, ['kernel'])).toBe('nowhere');
  });
});

describe('the lines that a lesson cites', () => {
  const labels = (names: readonly string[]): readonly string[] =>
    excerpt(names, 'corrected', 'en').flatMap(({ lines }) => lines.map(({ at }) => at));
  const isLabel = (word: string): boolean => labels([word]).length === 1 && /\d$/.test(word);
  /** The labels in backquotes that no listing of the story prints. */
  const unprinted = (story: string): readonly string[] => {
    const printed = [...story.matchAll(/^```listing.*\n([^]*?)^```$/gm)].map(([, names = '']) =>
      labels(names.split(/\s+/)),
    );
    const cited = [...story.matchAll(/`([A-Z]+\d+)`/g)].map(([, word = '']) => word);
    return [...new Set(cited)].filter((word) => isLabel(word) && !printed.flat().includes(word));
  };

  it.each(ids)('are in its listings: %s', (id) => {
    for (const language of languages) expect(unprinted(storyOf(id, language))).toEqual([]);
  });

  it('would be missed', () => {
    expect(unprinted('`PW7`, `PW8` and `X9`\n\n```listing\nPW8\n```\n')).toEqual(['PW7']);
  });
});
