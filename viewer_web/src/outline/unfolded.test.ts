import { describe, expect, it } from 'vitest';
import { textOf, traceOf } from '../testing/traces.js';
import { Outline } from './outline.js';
import { none } from './table.js';
import { treeKeys } from './tree-keys.js';
import { Unfolded } from './unfolded.js';

// Two polygons, A with rows from -1 on, and then B; each row shows lines.
async function tree(): Promise<Unfolded> {
  const outline = new Outline(await traceOf(textOf('small.zbuffer.signs.jsonl')));
  outline.read();
  return new Unfolded(outline);
}

const rowsOf = (unfolded: Unfolded): readonly number[] =>
  Array.from({ length: unfolded.length }, (_, row) => unfolded.nodeAt(row));

describe('the rows of an outline', () => {
  it('are at the top level, until something is unfolded', async () => {
    const unfolded = await tree();
    const { outline } = unfolded;
    const [a = none, b = none] = rowsOf(unfolded);
    expect(unfolded.length).toBe(2);
    unfolded.unfold(a);
    expect(unfolded.length).toBe(2 + (outline.nodes.children[a] ?? 0));
    expect(unfolded.rowOf(b)).toBe(1 + (outline.nodes.children[a] ?? 0));
    unfolded.fold(a);
    expect(rowsOf(unfolded)).toEqual([a, b]);
  });

  it('unfold down to a step, and fold again after it', async () => {
    const unfolded = await tree();
    const { outline } = unfolded;
    const [a = none, b = none] = rowsOf(unfolded);
    const inRow = outline.nodes.first[a + 2] ?? 0;
    unfolded.follow(outline.at(inRow));
    expect(unfolded.isUnfolded(a)).toBe(true);
    expect(unfolded.nodeAt(unfolded.rowOf(outline.at(inRow)))).toBe(outline.at(inRow));
    unfolded.follow(b);
    expect(rowsOf(unfolded)).toEqual([a, b]);
  });

  it('stay unfolded once the reader has acted on them', async () => {
    const unfolded = await tree();
    const { outline } = unfolded;
    const [a = none, b = none] = rowsOf(unfolded);
    unfolded.follow(outline.at(outline.nodes.first[a + 2] ?? 0));
    unfolded.keep();
    unfolded.follow(b);
    expect(unfolded.isUnfolded(a)).toBe(true);
    unfolded.fold(a);
    unfolded.follow(outline.at(outline.nodes.first[a + 2] ?? 0));
    expect(unfolded.isUnfolded(a)).toBe(false);
    expect(unfolded.rowOf(a + 2)).toBe(0); // a folded node stands for its descendants
  });

  it('change their version only when they change', async () => {
    const unfolded = await tree();
    const { version } = unfolded;
    unfolded.follow(none);
    expect(unfolded.version).toBe(version);
    unfolded.unfold(0);
    expect(unfolded.version).not.toBe(version);
  });
});

describe('keys in an outline', () => {
  it('move from row to row, into a node and out of it', async () => {
    const unfolded = await tree();
    const [a = none, b = none] = rowsOf(unfolded);
    const go = (key: string, from: number): number | null => treeKeys(key, from, 5, unfolded);
    expect(go('ArrowDown', a)).toBe(b);
    expect(go('ArrowDown', b)).toBe(b);
    expect(go('ArrowLeft', a)).toBe(a);
    expect(go('ArrowRight', a)).toBe(a);
    expect(unfolded.isUnfolded(a)).toBe(true);
    expect(go('ArrowRight', a)).toBe(a + 1);
    expect(go('ArrowLeft', a + 1)).toBe(a);
    expect(go('End', a)).toBe(b);
    expect(go('Home', b)).toBe(a);
    expect(go('PageDown', a)).toBe(rowsOf(unfolded)[5]);
    expect(go('ArrowLeft', a)).toBe(a);
    expect(unfolded.isUnfolded(a)).toBe(false);
    expect(go('*', b)).toBe(b);
    expect([a, b].map((node) => unfolded.isUnfolded(node))).toEqual([true, true]);
    expect(go('x', a)).toBe(null);
  });
});
