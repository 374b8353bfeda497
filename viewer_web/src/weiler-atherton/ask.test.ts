import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import { nextQuestion } from '../predict/questions.js';
import { sayRight } from '../predict/say.js';
import type { Trace } from '../replay/trace.js';
import { answers, questionFrom } from '../testing/questions.js';
import { textOf, traceOf } from '../testing/traces.js';

/**
 * The scene of lesson 14. W is the rectangle from (2, 2) to (14, 12) with the depth x / 16. Q is the rectangle from (4, 6)
 * to (8, 14) at 3/4. S is the whole area, 16 x 16, at -1/2. Downward on the screen, Q extends beyond the lower side of W.
 */
const wall = (): Promise<Trace> => traceOf(textOf('wall.weiler-atherton.signs.jsonl'));

describe('PaintRegions asks', () => {
  it('for the depths of two polygons at a pixel of regions of both', async () => {
    // W has the depth x / 16, which is 9/32 at x = 9/2. Q lies at 3/4.
    const question = questionFrom(await wall(), 1, 'painted');
    expect(question.about).toEqual({ polygon: 'W', other: 'Q', point: ['9/2', '13/2'] });
    expect(answers(question)).toEqual({ bothDepths: ['0.28125', '0.75'], nearerThere: ['<'] });
  });
});

describe('Weiler and Atherton’s algorithm asks', () => {
  it('which polygon is the first by depth', async () => {
    // W has 2/16 at its left side and 14/16 at its right side, which is more than 3/4 and -1/2.
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

  it('which parts are inside the clip polygon and which are outside', async () => {
    // Q lies on both sides of y = 12. S surrounds W, so its part outside is a ring with an outer outline and a hole.
    const question = questionFrom(await wall(), 1, 'parted');
    expect(question.about).toEqual({ clip: 'W', pieces: 3 });
    expect(answers(question)).toEqual({ within: ['Q', 'S'], beyond: ['Q', 'S'], outlines: ['2'] });
    expect(question.parts[2]?.given).toEqual([{ value: 'S', of: 'polygon' }]);
  });

  it('where an outline enters the clip polygon and where it leaves it', async () => {
    // Along Q: the lower side, up the left side across y = 12, the upper side, and down the right side across y = 12.
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

  it('and expects neither of an outline that surrounds it', async () => {
    const question = questionFrom(await wall(), 53, 'entering');
    expect(question.about).toEqual({ polygon: 'S', clip: 'W' });
    expect(answers(question)).toEqual({ enters: [], leaves: [] });
  });

  it('where it enters along a side that both share', async () => {
    // W is clipped by the inside part of Q, (4, 6) to (8, 12). Between x = 8 and x = 4 both lie above y = 12.
    const question = questionFrom(await wall(), 69, 'entering');
    expect(question.about).toEqual({ polygon: 'W', clip: 'Q' });
    expect(answers(question)).toEqual({ enters: ['(8, 12)'], leaves: ['(4, 12)'] });
  });

  it('for the walk around the part inside', async () => {
    // From vertex 3 at (4, 12), along Q by (4, 6) and (8, 6) to (8, 12), where it leaves; along the lower side of W back to
    // (4, 12).
    const first = questionFrom(await wall(), 42, 'walk');
    expect(first.about).toEqual({ polygon: 'Q', clip: 'W', from: '3' });
    expect(answers(first)).toEqual({ walked: ['4', '5', '6'] });
    // From vertex 2 at (8, 12), along W to vertex 3 at (4, 12), where it leaves; along Q by vertex 7 at (4, 6) and vertex 8
    // at (8, 6) back to (8, 12).
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

  it('what is behind, and what happens to the clip polygon', async () => {
    // At (6, 9) Q has 3/4 and W 6/16; at (8, 7) S has -1/2 and W 8/16.
    const question = questionFrom(await wall(), 1, 'behind');
    expect(answers(question)).toEqual({ hidden: ['S'], next: ['again'] });
  });

  it('which list is popped from the stack', async () => {
    // Q is nearer than W. Both are pushed on the stack, Q first, above the parts outside W.
    const again = questionFrom(await wall(), 1, 'stack');
    expect(again.about).toEqual({ clip: 'W', nearer: ['Q'] });
    expect(answers(again)).toEqual({ clips: ['Q'], listed: ['Q', 'W'] });
    // Q is visible there. The part of W outside Q covers the parts of Q and S outside W.
    const other = questionFrom(await wall(), again.until, 'stack');
    expect(other.about).toEqual({ clip: 'Q', nearer: [] });
    expect(answers(other)).toEqual({ clips: ['W'], listed: ['W'] });
    // After that there is only one list, so there is nothing to ask.
    expect(nextQuestion(await wall(), other.until, new Set(['stack']), [])).toBeNull();
  });

  it('which polygons pierce each other, if the planes of some intersect', async () => {
    expect(nextQuestion(await wall(), 1, new Set(['piercing']), [])).toBeNull();
    // A has x from 1 to 13 and the depth 1/4. B has x from 4 to 8 and the depth 3/4. C has x from 7 to 15 and the depth (x
    // - 7) / 8. That is 1/4 at x = 9, where A is, and 3/4 at x = 13, where B is not. So A and C are split in two.
    const wedge = await traceOf(textOf('wedge.weiler-atherton.polygons.jsonl'));
    const question = questionFrom(wedge, 1, 'piercing');
    expect(question.about).toEqual({ polygons: ['A', 'B', 'C'] });
    expect(question.parts[1]?.options.map(({ value }) => value)).toEqual(['3', '4', '5', '6', '7']);
    expect([...(answers(question)['pierced'] ?? [])].sort()).toEqual(['A', 'C']);
    expect(answers(question)['pieces']).toEqual(['5']);
  });
});
