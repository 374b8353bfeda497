import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import { answers, questionFrom } from '../testing/questions.js';
import { textOf, traceOf } from '../testing/traces.js';
import type { Trace } from '../replay/trace.js';
import { nextQuestion } from '../predict/questions.js';
import { sayRight } from '../predict/say.js';

/**
 * The scene of lesson 14. W is the rectangle from (2, 2) to (14, 12), its depth is x / 16; Q the one from (4, 6) to (8, 14) at
 * 3/4; S the whole area, 16 x 16, at -1/2. Down the screen Q goes past the lower side of W.
 */
const wall = (): Promise<Trace> => traceOf(textOf('wall.weiler-atherton.signs.jsonl'));

describe('Weiler and Atherton’s algorithm asks', () => {
  it('which polygon is the first by depth', async () => {
    // W has 2/16 at its left side and 14/16 at its right one, which is more than 3/4 and -1/2.
    const question = questionFrom(await wall(), 1, 'sort');
    expect(question.about).toEqual({ pieces: 3 });
    expect(answers(question)).toEqual({ first: ['W'], depth: ['7/8'] });
    expect(question.parts[1]?.options.map(({ note }) => note?.(texts.en))).toEqual([
      '−1/2',
      '1/8',
      '3/4',
      '7/8',
    ]);
  });

  it('what lies inside the clip polygon and what outside', async () => {
    // Q lies on both sides of y = 12; S lies around W: what is outside is a ring, with an outline and one of its hole.
    const question = questionFrom(await wall(), 1, 'parted');
    expect(question.about).toEqual({ clip: 'W', pieces: 3 });
    expect(answers(question)).toEqual({ within: ['Q', 'S'], beyond: ['Q', 'S'], outlines: ['2'] });
    expect(question.parts[2]?.given).toEqual([{ value: 'S', of: 'polygon' }]);
  });

  it('where an outline enters the clip polygon and where it leaves it', async () => {
    // Along Q: the lower side, up the left one past y = 12, the upper one, down the right one past y = 12.
    const question = questionFrom(await wall(), 42, 'entering');
    expect(question.about).toEqual({ polygon: 'Q', clip: 'W' });
    expect(question.parts[0]?.options.map(({ value }) => value)).toEqual([
      '(8, 14)',
      '(4, 14)',
      '(4, 12)',
      '(4, 6)',
      '(8, 6)',
      '(8, 12)',
    ]);
    expect(answers(question)).toEqual({ enters: ['(4, 12)'], leaves: ['(8, 12)'] });
    const [enters] = question.parts;
    if (enters === undefined) throw new Error('It asks nothing.');
    expect(languages.map((language) => sayRight(enters, language))).toEqual(['(4, 12)', '(4; 12)']);
  });

  it('and that an outline around it does neither', async () => {
    const question = questionFrom(await wall(), 53, 'entering');
    expect(question.about).toEqual({ polygon: 'S', clip: 'W' });
    expect(answers(question)).toEqual({ enters: [], leaves: [] });
  });

  it('where it enters along a side that both share', async () => {
    // W, clipped by what of Q is inside, (4, 6) to (8, 12): between x = 8 and x = 4 both are above y = 12.
    const question = questionFrom(await wall(), 69, 'entering');
    expect(question.about).toEqual({ polygon: 'W', clip: 'Q' });
    expect(answers(question)).toEqual({ enters: ['(8, 12)'], leaves: ['(4, 12)'] });
  });

  it('how one walks round the part inside', async () => {
    // From (4, 12), 3, along Q by (4, 6) and (8, 6) to (8, 12), where it leaves; along the lower side of W back to (4, 12).
    const first = questionFrom(await wall(), 42, 'walk');
    expect(first.about).toEqual({ polygon: 'Q', clip: 'W', from: '3' });
    expect(answers(first)).toEqual({ walked: ['4', '5', '6'] });
    // From (8, 12), 2, along W to (4, 12), 3, where it leaves; along Q by (4, 6), 7, and (8, 6), 8, back to (8, 12).
    const second = questionFrom(await wall(), 69, 'walk');
    expect(second.parts[0]?.given?.map(({ note }) => note?.(texts.en))).toEqual([
      '(14, 12)',
      '(8, 12)',
      '(4, 12)',
      '(2, 12)',
      '(2, 2)',
      '(14, 2)',
      '(4, 6)',
      '(8, 6)',
    ]);
    expect(second.about.from).toBe('2');
    expect(answers(second)).toEqual({ walked: ['3', '7', '8'] });
  });

  it('what is behind, and what comes of the clip polygon', async () => {
    // At (6, 9) Q has 3/4 and W 6/16; at (8, 7) S has -1/2 and W 8/16.
    const question = questionFrom(await wall(), 1, 'behind');
    expect(answers(question)).toEqual({ hidden: ['S'], next: ['again'] });
  });

  it('which list comes off the stack', async () => {
    // Q is nearer than W: both go on the stack, Q first, above what is outside of W.
    const again = questionFrom(await wall(), 1, 'stack');
    expect(again.about).toEqual({ clip: 'W', nearer: ['Q'] });
    expect(answers(again)).toEqual({ clips: ['Q'], listed: ['Q', 'W'] });
    // Q is visible there. What of W is outside of Q lies on the parts of Q and S that are outside of W.
    const other = questionFrom(await wall(), again.until, 'stack');
    expect(other.about).toEqual({ clip: 'Q', nearer: [] });
    expect(answers(other)).toEqual({ clips: ['W'], listed: ['W'] });
    // Then there is one list, and but for that none.
    expect(nextQuestion(await wall(), other.until, new Set(['stack']), [])).toBeNull();
  });

  it('which polygons pierce each other, if there are planes that meet in some', async () => {
    expect(nextQuestion(await wall(), 1, new Set(['piercing']), [])).toBeNull();
    // A, x from 1 to 13, lies at 1/4, B, from 4 to 8, at 3/4; C, from 7 to 15, has the depth (x - 7) / 8: 1/4 at x = 9, where A is.
    // 3/4 it has at x = 13, where B is not. A and C are cut in two.
    const wedge = await traceOf(textOf('wedge.weiler-atherton.polygons.jsonl'));
    const question = questionFrom(wedge, 1, 'piercing');
    expect(question.about).toEqual({ polygons: ['A', 'B', 'C'] });
    expect(question.parts[1]?.options.map(({ value }) => value)).toEqual(['3', '4', '5', '6', '7']);
    expect([...(answers(question)['pierced'] ?? [])].sort()).toEqual(['A', 'C']);
    expect(answers(question)['pieces']).toEqual(['5']);
  });
});
