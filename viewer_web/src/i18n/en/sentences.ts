import type { Sentences } from '../../language/texts.js';
import { list, point, short } from '../../language/words.js';
import type { CommonEvents } from '../../trace/events.js';
import { exact } from './exact.js';
import { purposes } from './page.js';

const { answer, causes, decided } = exact;

/** The sentences of the events that all algorithms tell. */
export const sentences: Pick<Sentences, keyof CommonEvents> = {
  plane: ({ polygon, plane }) => `The plane of ${polygon}: a, b, c, d = ${list(plane)}.`,
  call: ({ of }) => `${of} begins: ${purposes[of]}`,
  depth: ({ polygon, point: at, z }) =>
    `At the point ${point(at)} the plane of ${polygon} has depth ${short(z)}.`,
  fault: ({ reason, x, y }) =>
    x === undefined || y === undefined
      ? `The printed text fails here: ${reason}. The run ends.`
      : `The printed text fails here: ${reason}, pixel ${point([x, y])}.`,
  disagree: ({ of, taken, exact, cause }) =>
    `Wrong, ${decided[of]}: computed ${answer(taken)}, exactly ${answer(exact)}. ${causes[cause]}`,
};
