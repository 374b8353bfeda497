import { describe, expect, it } from 'vitest';
import { Lines } from './lines.js';

/** The blocks of a file as text. Each buffer is transferred, as a worker does. */
async function blocksOf(text: string): Promise<readonly string[]> {
  const found: string[] = [];
  for await (const block of new Lines(new Blob([text])).blocks()) {
    found.push(new TextDecoder().decode(block));
    structuredClone(block, { transfer: [block.buffer] });
  }
  return found;
}

describe('a file in blocks whose buffers are transferred', () => {
  const long = 'x'.repeat(200_000);

  it.each([
    ['nothing', '', []],
    ['no whole line', 'hello', ['hello']],
    ['whole lines', 'a\nb\n', ['a\nb\n']],
    ['a last line that is cut', 'a\nb', ['a\n', 'b']],
    ['a line longer than a block', `${long}\nb\n`, [`${long}\nb\n`]],
    ['a long line that is cut', `a\n${long}`, ['a\n', long]],
  ])('%s', async (_name, text, blocks) => {
    expect(await blocksOf(text)).toEqual(blocks);
  });
});
