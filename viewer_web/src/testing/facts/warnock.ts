import type { CommonEvents, FamilyEvents, WarnockEvents } from '../../trace/events.js';
import type { Box, N } from '../../trace/values.js';
import { answered, listed, none, of, only, said, total } from './fact.js';
import type { Fact, Facts, Moment } from './fact.js';
import { orderOfNumbers, value } from './shown.js';

const corners = {
  lb: said(/top left/iu, /лев\S+ верхн/iu),
  lt: said(/bottom left/iu, /лев\S+ нижн/iu),
  rb: said(/top right/iu, /прав\S+ верхн/iu),
  rt: said(/bottom right/iu, /прав\S+ нижн/iu),
} as const;

const background = said(/background/u, /фон/u);
const inside = said(/ lies in | is inside/u, / лежит в /u);
export const outside = said(/lies outside/u, /лежит вне/u);

/** A point by its coordinates; a corner of the window by its name. */
function place(at: readonly N[], { after }: Moment): Fact {
  const window = after.warnock?.window;
  const corner = window && cornerAt(at.map(value), window);
  return corner ? { says: [corners[corner]] } : { numbers: at };
}

function cornerAt(
  [x, y]: readonly number[],
  [left, top, width, height]: Box,
): keyof typeof corners | null {
  const across = x === left ? 'l' : x === left + width ? 'r' : null;
  const down = y === top ? 'b' : y === top + height ? 't' : null;
  return across && down && `${across}${down}`;
}

const both = (...facts: readonly Fact[]): Fact => ({
  ids: facts.flatMap(({ ids = [] }) => ids),
  numbers: facts.flatMap(({ numbers = [] }) => numbers),
  says: facts.flatMap(({ says = [] }) => says),
});

const xy = ({ vertex }: { readonly vertex: readonly N[] }): Fact => only(...vertex.slice(0, 2));

/** The owner of a colour: the one known for the window, or in a coarse trace all polygons with that colour. */
function owner(color: string, id: string | null, isGround: boolean, moment: Moment): Fact {
  if (isGround) return { says: [background] };
  if (id !== null) return { ids: [id] };
  const { detail, scene } = moment;
  if (detail !== 'windows') return { says: [background] };
  const ids = (scene.polygons ?? []).filter((each) => each.color === color).map(({ id }) => id);
  return { ids, says: color === scene.background ? [background] : [] };
}

const ground = ['W7', 'W10', 'WS4', 'WF5', 'WF6'];
const atPoint = ['W9', 'WS5', 'WF11'];

/** The polygon that hides all others: the one that was found, or the only one that surrounds the window. */
const hiding = ({ covered, after }: Moment): string | null =>
  covered[1] ?? after.warnock?.surrounding?.at(-1)?.[0] ?? null;

export const known = (id: string | null): Fact => (id === null ? none : { ids: [id] });

type WindowEvent = Exclude<keyof (CommonEvents & WarnockEvents), keyof FamilyEvents>;

export const warnockFacts: Facts<WindowEvent> = {
  plane: ({ polygon, plane }) => of(polygon, ...plane),
  call: () => none,
  depth: ({ polygon, point, z }, moment) => both(of(polygon, z), place(point, moment)),
  fault: ({ x, y }) => (x === undefined || y === undefined ? none : only(x, y)),
  disagree: ({ taken, exact }) =>
    only(...[taken, exact].flatMap((each) => (typeof each === 'number' ? [each] : range(each)))),
  push: ({ window, apl = [] }) => ({ ids: listed(apl.map(([id]) => id)), numbers: window }),
  skip: ({ window }) => ({ numbers: window }),
  pop: ({ at, window }, { after, detail, level }) => {
    if (at === 'WF2') return only(...window, level);
    const ids = (after.warnock?.apl ?? []).map(([id]) => id);
    return { ids: detail === 'windows' ? [] : listed(ids), numbers: window };
  },
  corners: ({ z }) => only(z),
  box: ({ polygon, outside: is }) => ({
    ids: [polygon],
    says: answered(is, outside, said(/meets the window/u, /пересекается с окном/u)),
  }),
  discard: ({ polygon }) => ({
    ids: [polygon],
    says: [said(/is not counted/u, /не учитывается/u)],
  }),
  count: ({ polygon, count }) => of(polygon, count),
  compare: ({ polygon, corner, z, against, nearer }) => ({
    ...of(polygon, z, against),
    says: [
      ...(corner === undefined ? [] : [corners[corner]]),
      ...(nearer === (orderOfNumbers(z, against) === 1)
        ? answered(
            nearer,
            said(/is nearer: .* > /u, / ближе: .* > /u),
            said(/is not nearer: .* ≯ /u, /не ближе: .* ≯ /u),
          )
        : answered(
            nearer,
            said(/counts as nearer: .* against /u, /считается ближе: .* против /u),
            said(/counts as not nearer: .* against /u, /считается не ближе: .* против /u),
          )),
    ],
  }),
  nearer: ({ polygon, corners: at, k }) => ({
    ...of(polygon, ...(k === 0 ? [4] : [k, 4])),
    says: k === 4 ? [] : at.map((corner) => corners[corner]),
  }),
  uncover: ({ polygon }, { covered: [before] }) => both(of(polygon), known(before)),
  surround: ({ polygon, point, inside: is }, moment) =>
    both(of(polygon), place(point, moment), { says: answered(is, inside, outside) }),
  mark: ({ polygon }) => of(polygon),
  cover: ({ polygon }) => of(polygon),
  insider: ({ polygon, inside: is }) => ({
    ids: [polygon],
    says: answered(
      is,
      said(/ lies strictly/u, /[^е] лежит строго/u),
      said(/does not lie strictly/u, /не лежит строго/u),
    ),
  }),
  summary: ({ count, hasSurround }, { covered }) =>
    both(
      only(count),
      hasSurround ? known(covered[1]) : { says: [said(/none is known/u, /неизвестно/u)] },
    ),
  decide: ({ case: which }, moment) => {
    if (which === 'empty') return { says: [background] };
    if (which === 'surrounded')
      return both(known(hiding(moment)), { says: [said(/hides everything/u, /закрывает всё/u)] });
    const [first, ...others] = (moment.after.warnock?.apl ?? []).map(([id]) => id);
    if (which === 'pixel') return { says: [said(/no larger than a pixel/u, /не больше пикселя/u)] };
    if (which === 'split') return { says: [said(/is split/u, /делится/u)] };
    return first === undefined || others.length > 0
      ? { says: [background] }
      : { ids: [first], says: [background] };
  },
  fill: ({ at, rect, color }, moment) =>
    both(
      only(rect[2] * rect[3]),
      owner(
        color,
        atPoint.includes(at) ? moment.nearest : hiding(moment),
        ground.includes(at),
        moment,
      ),
    ),
  nearest: ({ polygon, z }) => of(polygon, z),
  color: ({ point, color }, moment) =>
    both(only(...point), owner(color, moment.nearest, false, moment)),
  orient: ({ at, polygon, edge, point, value: f, sign }, moment) =>
    both(of(polygon, edge, f), at === 'TF2' || at === 'OA4' ? place(point, moment) : none, {
      says: [
        {
          '-1': said(/negative side/u, /отрицательную сторону/u),
          0: said(/on the line/u, /на прямой/u),
          1: said(/positive side/u, /положительную сторону/u),
        }[sign],
      ],
    }),
  clip_begin: ({ polygon }) => of(polygon),
  clip_side: ({ side, from, to }, { after }) =>
    both(only(side, 4, ...from, ...to), { says: [sideOf(from, to, after.warnock?.window)] }),
  clip_sign: ({ vertex, sign }) => ({
    ...xy({ vertex }),
    says: answered(
      sign > 0,
      said(/counts as outside/u, /считается внешней/u),
      said(/counts as inside/u, /считается внутренней/u),
    ),
  }),
  clip_cross: xy,
  clip_keep: xy,
  clip_drop: xy,
  clip_list: ({ count }) => (count === 0 ? none : only(count)),
  clip_result: ({ polygon, vertices }) =>
    of(polygon, ...(vertices.length === 0 ? [] : [vertices.length])),
  row: ({ at, row, left, right, first, end }, { after }) => {
    const [id, ...others] = at === 'PR1' ? [] : (after.warnock?.apl ?? []).map(([each]) => each);
    const columns = first < end ? new Set([first, end - 1]) : [];
    return {
      ids: id === undefined || others.length > 0 ? [] : [id],
      numbers: [row, left, right, ...columns],
    };
  },
  draw: ({ polygon, runs }) =>
    runs.length === 0 ? of(polygon) : of(polygon, total(runs), runs.length),
};

const range = (answer: unknown): readonly number[] => {
  if (!Array.isArray(answer)) return [];
  const [first, end] = answer as [number, number];
  if (end - first === 1) return [first];
  return first < end ? [first, end - 1] : [];
};

function sideOf(from: readonly N[], to: readonly N[], window: Box | null | undefined) {
  const [x, y] = window ?? [NaN, NaN];
  const isLevel = value(from[1] ?? 'nan') === value(to[1] ?? 'nan');
  if (isLevel)
    return value(to[1] ?? 'nan') === y
      ? said(/the top one/u, /верхняя/u)
      : said(/the bottom one/u, /нижняя/u);
  return value(to[0] ?? 'nan') === x
    ? said(/the left one/u, /левая/u)
    : said(/the right one/u, /правая/u);
}
