import type { Blocks, Heading, Inlines, PinLink, Story } from './story.js';

/** A place that an address can name in a story. */
export type Mark = Heading | PinLink;

type Written = Pick<Story, 'title' | 'goals' | 'blocks'>;

/** The headings and pins of a story, in reading order. */
function* marksIn({ title, goals, blocks }: Written): Generator<Mark> {
  yield* pinsOf([...title, ...goals.flat()]);
  yield* marksOf(blocks);
}

function* marksOf(blocks: Blocks): Generator<Mark> {
  for (const block of blocks) {
    if (block.is === 'heading') yield block;
    if (block.is === 'heading' || block.is === 'paragraph') yield* pinsOf(block.text);
    else if (block.is === 'figure') yield* pinsOf(block.caption);
    else if (block.is === 'list') yield* marksOf(block.items.flat());
    else if (block.is === 'quote') yield* marksOf(block.blocks);
    else if (block.is === 'question' || block.is === 'exercise') {
      yield* marksOf([...block.blocks, ...(block.answer ?? [])]);
    } else if (block.is === 'table') yield* pinsOf([...block.head, ...block.rows.flat()].flat());
  }
}

function* pinsOf(inlines: Inlines): Generator<PinLink> {
  for (const inline of inlines) {
    if (typeof inline === 'string') continue;
    if (inline.is === 'pin') yield inline;
    if (inline.is !== 'formula' && inline.is !== 'code') yield* pinsOf(inline.text);
  }
}

/**
 * The names of a story's places, the same in both languages. A heading has its number, a pin its name. If several links
 * lead to a pin, the name also has the number of the link, as in `split.2`.
 */
export function placesIn(story: Written): ReadonlyMap<Mark, string> {
  const times = new Map<string, number>();
  const places = new Map<Mark, string>();
  let headings = 0;
  for (const mark of marksIn(story)) {
    if (mark.is === 'heading') places.set(mark, String(++headings));
    else {
      const time = (times.get(mark.pin) ?? 0) + 1;
      times.set(mark.pin, time);
      places.set(mark, time === 1 ? mark.pin : `${mark.pin}.${time}`);
    }
  }
  return places;
}
