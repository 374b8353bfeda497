import { History } from '../history/history.js';
import type { Entry, Outcome } from '../history/entry.js';
import type { Pixel } from '../picture/pixel.js';
import { textOf, traceOf } from './traces.js';

export async function readHistory(text: string, pixel: Pixel): Promise<History> {
  const history = new History(await traceOf(text), pixel);
  history.read();
  return history;
}

export const historyIn = (name: string, pixel: Pixel): Promise<History> =>
  readHistory(textOf(`${name}.jsonl`), pixel);

export const steps = ({ entries }: History): readonly (readonly [number, Outcome])[] =>
  entries.map(({ step, outcome }) => [step, outcome]);

export const last = <T>(list: readonly T[]): T => {
  const item = list.at(-1);
  if (item === undefined) throw new Error('an empty list');
  return item;
};

export const say = (entry: Entry, history: History): string => history.sentence(entry, 'en');
