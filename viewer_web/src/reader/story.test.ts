import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { sampleLesson } from '../testing/lessons.js';
import { lessonStory, listedIn, readStory } from './story.js';
import type { LessonStory } from './story.js';

const packed = (text: string): Blob => new Blob([Uint8Array.from(gzipSync(text))]);

/** The lesson with one paragraph of these inlines. */
function saying(...text: readonly unknown[]): object {
  const story = { title: ['x'], blocks: [{ is: 'paragraph', text }] };
  return sampleLesson({ story: { en: story, ru: story } });
}

const refused = (value: unknown): string => {
  try {
    lessonStory(value);
  } catch (refusal) {
    return (refusal as Error).message;
  }
  return 'taken';
};

describe('the file of a lesson', () => {
  it('is read with its pins, figures and both texts', async () => {
    const lesson: LessonStory = await readStory(packed(JSON.stringify(sampleLesson())));
    expect(lesson.pins.get('scanline')).toEqual({ run: 'depths', step: 33 });
    expect([...lesson.story.en.figures.keys()]).toEqual(['windows.svg']);
    expect(lesson.story.ru.blocks[1]).toEqual({ is: 'heading', level: 2, text: ['Первые окна'] });
  });

  it('is read with its frame, which an older lesson lacks', () => {
    const lesson = lessonStory(sampleLesson());
    expect([lesson.minutes, lesson.prerequisites?.map(({ id }) => id)]).toEqual([
      25,
      ['second', 'nowhere'],
    ]);
    expect(lesson.sources?.[0]?.translations).toEqual({ ru: 'Роджерс Д. Основы.' });
    expect(lesson.story.en.goals[1]).toEqual(['count']);
    const story = { title: ['x'], blocks: [] };
    const older = { format: 'vidno-lesson/1', id: 'x', traces: {}, pins: {} };
    expect(lessonStory({ ...older, story: { en: story, ru: story } }).story.en.goals).toEqual([]);
  });

  it('names its places alike in both languages: headings by number, pins by name and occurrence', () => {
    const { en, ru } = lessonStory(sampleLesson()).story;
    const names = ['1', 'first', 'second', '2', 'first.2', '3', 'scanline'];
    expect([...en.places.values()]).toEqual(names);
    expect([...ru.places.values()]).toEqual(names);
  });

  it('may have unknown fields', () => {
    expect(lessonStory(sampleLesson({ later: 1 })).id).toBe('first');
  });

  it.each<[string, unknown, string]>([
    ['a later format', sampleLesson({ format: 'vidno-lesson/2' }), 'format newerFormat'],
    ['a later format with other fields', { format: 'vidno-lesson/2' }, 'format newerFormat'],
    ['a pin of no run', sampleLesson({ traces: { run: 'x' } }), 'pins.scanline.run noSuchRun'],
    ['no text', sampleLesson({ story: {} }), 'story.en missing'],
    ['a way to no pin', saying({ is: 'pin', pin: 'x', text: [] }), 'story.en noSuchPin x'],
    [
      'an address that is a program',
      saying({ is: 'link', url: 'javascript:alert(1)', text: [] }),
      'story.en.blocks[0].text[0].url noWebAddress',
    ],
    [
      'a source whose address is a program',
      sampleLesson({
        sources: [{ authors: '', year: '', title: '', in: '', url: 'javascript:alert(1)' }],
      }),
      'sources[0].url noWebAddress',
    ],
    ['an unknown inline', saying({ is: 'image' }), 'story.en.blocks[0].text[0].is oneOf'],
    ['a name that all objects have', saying({ is: 'toString' }), '.is oneOf'],
    ['a number among words', saying(1), 'story.en.blocks[0].text[0] object'],
  ])('is refused with %s', (_what, value, message) => {
    expect(refused(value)).toContain(message);
  });

  it('is refused if it is not JSON, not gzip, or unpacks to too much', async () => {
    await expect(readStory(packed('{'))).rejects.toThrow('notJson');
    await expect(readStory(new Blob(['x']))).rejects.toThrow();
    await expect(readStory(packed(' '.repeat(16_000_001)))).rejects.toThrow(RangeError);
  });
});

describe('what the listings of a lesson print', () => {
  it('is their procedures and lines, always in the same list', () => {
    const listing = (...names: readonly string[]): object => ({
      is: 'listing',
      edition: 'corrected',
      names,
    });
    const story = { title: ['x'], blocks: [listing('PW3', 'W13'), listing('Depth')] };
    const lesson = lessonStory(sampleLesson({ story: { en: story, ru: story } }));
    expect(listedIn(lesson)).toEqual(['PW3', 'W13', 'Depth']);
    expect(listedIn(lesson)).toBe(listedIn(lesson));
    expect(listedIn(null)).toEqual([]);
  });
});
