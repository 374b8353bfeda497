import { edgeThing, cornerThing, polygonThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import type { Mark } from '../picture/mark.js';
import { edgeOf } from '../picture/mark.js';
import { marksOfThing } from '../picture/marks.js';
import type { Target } from '../picture/target.js';
import type { Corner } from '../trace/values.js';
import { none, parts as forms } from './question.js';
import type { Asks, Option, Question } from './question.js';
import { sayNoted } from './say.js';
import { answerOf } from './sheet.js';
import type { Sheet } from './sheet.js';

const roles = { one: 'radio', some: 'checkbox', row: 'button', table: 'button' } as const;

/** The places of an option in the picture: its own ones, or those of the polygon, edge or corner that it is. */
function placesOf(question: Question, asks: Asks, option: Option, view: View): readonly Mark[] {
  if (option.places !== undefined) return option.places;
  const { value } = option;
  const of = forms[asks][1];
  if (of === 'polygon' && value !== none) return marksOfThing(polygonThing(value), view);
  if (of === 'corner') return marksOfThing(cornerThing(value as Corner), view);
  if (of !== 'edge' || value === none) return [];
  const marks = marksOfThing(edgeThing(Number(value)), view);
  if (marks.length > 0 || !('polygon' in question.about)) return marks;
  return edgeOf(view.header.scene.byId.get(question.about.polygon), Number(value), 'pointed');
}

/** The targets in the picture for a part of a question. */
export function targetsOf(
  view: View,
  question: Question,
  at: number,
  sheet: Sheet,
  press: (part: number, value: string) => void,
): readonly Target[] {
  const part = question.parts[at];
  if (part === undefined) return [];
  const { asks, options } = part;
  const [form, of] = forms[asks];
  const { ruledOut = [] } = sheet[at] ?? {};
  const chosen = answerOf(question, sheet)[at] ?? [];
  const asked = texts[view.language].predict.asks[asks];
  return options
    .filter(({ value }) => !ruledOut.includes(value))
    .flatMap((option) =>
      placesOf(question, asks, option, view).map((mark) => ({
        mark,
        label: `${asked} ${sayNoted(of, option, view.language)}`,
        role: roles[form],
        isChosen: chosen.includes(option.value),
        press: () => press(at, option.value),
      })),
    );
}
