import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { relationBy } from '../language/words.js';
import type { Decision } from '../trace/events.js';
import type { Operands } from '../trace/values.js';
import { Fraction, half } from './fraction.js';

/**
 * A decision line by line, as in a calculation by hand: the formula of FORMAT.md, the substituted numbers, and the result.
 * It is mathematical notation with the trace's names of the operands, the same in every language.
 */
type Lines = readonly string[];

/** The operands by name: those of the run, or the right ones. Null if one of them is not a number. */
type Numbers = ReadonlyMap<string, Fraction>;

export type Column = 'used' | 'exact';

/** Null if an operand is missing or not a number: then there is no calculation. */
export function calculation(of: Decision, operands: Operands, column: Column): Lines | null {
  const numbers = new Map<string, Fraction>();
  for (const [name, used, exact] of operands) {
    const number = Fraction.parse((column === 'used' ? used : exact) ?? '');
    if (number === null) return null;
    numbers.set(name, number);
  }
  return numbers.size === 0 ? null : linesOf(of, numbers);
}

/** Whether the run used operands that differ from the right ones. */
export const hasDrifted = (operands: Operands): boolean =>
  operands.some(([, used, exact]) => used !== exact);

function linesOf(of: Decision, numbers: Numbers): Lines | null {
  const has = (name: string): boolean => numbers.has(name);
  switch (of) {
    case 'orientation':
      return has('pivot.x') ? turn(numbers) : side(numbers);
    case 'left_of':
      return [...side(numbers), ...compared('a', get(numbers, 'line.a'), '0', Fraction.of(0n))];
    case 'nearer':
      return pair(numbers, 'z', 'against');
    case 'comparison':
      return has('a') ? pair(numbers, 'a', 'b') : points(numbers);
    case 'parallel':
      return has('p.c') ? planes(numbers) : edges(numbers);
    case 'outside':
    case 'inside':
      return box(numbers);
    case 'first_centre':
      return first(numbers, 'x');
    case 'last_centre':
      return last(numbers, 'x');
    case 'columns':
      return has('left')
        ? [...first(numbers, 'left'), ...last(numbers, 'right')]
        : columns(numbers);
    case 'rows':
      return rows(numbers);
    case 'visibility':
      return ['upper', 'lower'].filter(has).flatMap((horizon) => pair(numbers, 'y', horizon));
    case 'same_rounded':
      return ['v', 'w'].map((name) => {
        const number = get(numbers, name);
        return `⌊${name} + 1/2⌋ = ⌊${number.plus(half).text}⌋ = ${whole(number.plus(half).floor)}`;
      });
    case 'pixel':
      return [`⌊v⌋ = ⌊${get(numbers, 'v').text}⌋ = ${whole(get(numbers, 'v').floor)}`];
  }
}

function get(numbers: Numbers, name: string): Fraction {
  const found = numbers.get(name);
  if (found === undefined) throw new RangeError(`no operand ${name}`);
  return found;
}

const whole = (number: bigint): string => String(number).replace('-', '−');
const withZero = (value: Fraction): string =>
  value.sign === 0 ? '= 0' : `= ${value.text} ${relationBy[value.sign]} 0`;

/** The comparison of one number with another. */
function compared(name: string, a: Fraction, other: string, b: Fraction): Lines {
  return [`${name} ${relationBy[a.minus(b).sign]} ${other}`];
}

function pair(numbers: Numbers, one: string, other: string): Lines {
  const [a, b] = [get(numbers, one), get(numbers, other)];
  return [
    `${one} = ${a.text}`,
    `${other} = ${b.text}`,
    `${one} − ${other} ${withZero(a.minus(b))}`,
    ...compared(one, a, other, b),
  ];
}

function points(numbers: Numbers): Lines {
  const byX = pair(numbers, 'p.x', 'q.x');
  const isSame = get(numbers, 'p.x').minus(get(numbers, 'q.x')).sign === 0;
  return isSame ? [...byX, ...pair(numbers, 'p.y', 'q.y')] : byX;
}

/** The sum or the difference of two products. */
function products(
  formula: string,
  [a, b, c, d]: readonly [Fraction, Fraction, Fraction, Fraction],
  sign: '+' | '−',
): Lines {
  const [left, right] = [a.times(b), c.times(d)];
  const value = sign === '+' ? left.plus(right) : left.minus(right);
  return [
    `f = ${formula}`,
    `= ${a.inner} · ${b.inner} ${sign} ${c.inner} · ${d.inner}`,
    `= ${left.text} ${sign} ${right.inner}`,
    withZero(value),
  ];
}

function turn(numbers: Numbers): Lines {
  const way = (to: string, axis: string): Fraction =>
    get(numbers, `${to}.${axis}`).minus(get(numbers, `pivot.${axis}`));
  return products(
    '(aₓ − oₓ) (b_y − o_y) − (a_y − o_y) (bₓ − oₓ)'.replaceAll('_y', 'ᵧ'),
    [way('a', 'x'), way('b', 'y'), way('a', 'y'), way('b', 'x')],
    '−',
  );
}

function side(numbers: Numbers): Lines {
  const way = (axis: string): Fraction =>
    get(numbers, `p.${axis}`).minus(get(numbers, `line.${axis}`));
  return products(
    'a (pₓ − x) + b (pᵧ − y)',
    [get(numbers, 'line.a'), way('x'), get(numbers, 'line.b'), way('y')],
    '+',
  );
}

function edges(numbers: Numbers): Lines {
  const [pa, pb, qa, qb] = ['p.a', 'p.b', 'q.a', 'q.b'].map((name) => get(numbers, name)) as [
    Fraction,
    Fraction,
    Fraction,
    Fraction,
  ];
  return products('p.a · q.b − p.b · q.a', [pa, qb, pb, qa], '−');
}

function planes(numbers: Numbers): Lines {
  return ['a', 'b'].flatMap((name) => {
    const slope = (plane: string): Fraction | null => {
      const divisor = get(numbers, `${plane}.c`);
      return divisor.sign === 0 ? null : get(numbers, `${plane}.${name}`).over(divisor);
    };
    const [p, q] = [slope('p'), slope('q')];
    if (p === null || q === null) return ['c = 0'];
    return [`q.${name} / q.c − p.${name} / p.c = ${q.text} − ${p.inner} ${withZero(q.minus(p))}`];
  });
}

function box(numbers: Numbers): Lines {
  const bounds = ['xmin', 'ymin', 'xmax', 'ymax'].every((name) => numbers.has(`window.${name}`));
  if (!bounds) return [];
  const pairs = [
    ['xmax', 'xmin'],
    ['ymax', 'ymin'],
    ['xmin', 'xmax'],
    ['ymin', 'ymax'],
    ['xmin', 'xmin'],
    ['ymin', 'ymin'],
    ['xmax', 'xmax'],
    ['ymax', 'ymax'],
  ] as const;
  return pairs.map(([own, other]) => {
    const [a, b] = [get(numbers, `box.${own}`), get(numbers, `window.${other}`)];
    return `box.${own} = ${a.text} ${relationBy[a.minus(b).sign]} ${b.text} = window.${other}`;
  });
}

/** The check that a pixel is within a range. */
function within(numbers: Numbers, pixel: bigint, least: bigint, most: bigint): string {
  const [low, end] = [get(numbers, 'low').floor, get(numbers, 'end').floor];
  const [lowest, highest] = [low + least, end + most];
  const found = pixel < lowest ? lowest : pixel > highest ? highest : pixel;
  return found === pixel ? whole(pixel) : `${whole(pixel)} → ${whole(found)}`;
}

/** The first i with i + 1/2 >= x, from `low` to `end`. */
function first(numbers: Numbers, name: string, value = get(numbers, name)): Lines {
  const least = value.minus(half);
  const pixel = -Fraction.of(-least.p, least.q).floor;
  return [
    `${name} = ${value.text}`,
    `i + 1/2 ≥ ${value.text} ⇒ i = ⌈${least.text}⌉ = ${within(numbers, pixel, 0n, 0n)}`,
  ];
}

/** The last i with i + 1/2 <= x, from `low` - 1 to `end` - 1. */
function last(numbers: Numbers, name: string, value = get(numbers, name)): Lines {
  const most = value.minus(half);
  return [
    `${name} = ${value.text}`,
    `i + 1/2 ≤ ${value.text} ⇒ i = ⌊${most.text}⌋ = ${within(numbers, most.floor, -1n, -1n)}`,
  ];
}

type Vertex = readonly [x: Fraction, y: Fraction];

function outline(numbers: Numbers): readonly Vertex[] {
  const vertices: Vertex[] = [];
  for (let i = 0; numbers.has(`v${i}.x`); i++) {
    vertices.push([get(numbers, `v${i}.x`), get(numbers, `v${i}.y`)]);
  }
  return vertices;
}

const least = (numbers: readonly Fraction[]): Fraction =>
  numbers.reduce((a, b) => (a.minus(b).sign > 0 ? b : a));
const greatest = (numbers: readonly Fraction[]): Fraction =>
  numbers.reduce((a, b) => (a.minus(b).sign < 0 ? b : a));

function rows(numbers: Numbers): Lines {
  const heights = outline(numbers).map(([, y]) => y);
  if (heights.length === 0) return [];
  return [...first(numbers, 'min y', least(heights)), ...last(numbers, 'max y', greatest(heights))];
}

function columns(numbers: Numbers): Lines {
  const y = get(numbers, 'row').plus(half);
  const met: Fraction[] = [];
  const lines: string[] = [`y = ${y.text}`];
  const vertices = outline(numbers);
  vertices.forEach(([x1, y1], i) => {
    const next = (i + 1) % vertices.length;
    const [x2, y2] = vertices[next] ?? [x1, y1];
    const [before, after] = [y.minus(y1), y.minus(y2)];
    if (before.sign * after.sign > 0) return;
    const name = `v${i} v${next}`;
    if (y1.minus(y2).sign === 0) {
      met.push(x1, x2);
      lines.push(`${name}: x = ${x1.text}, ${x2.text}`);
      return;
    }
    const x = x1.plus(before.times(x2.minus(x1)).over(y2.minus(y1)));
    met.push(x);
    lines.push(
      `${name}: x = ${x1.text} + ${before.inner} · ${x2.minus(x1).inner} / ${y2.minus(y1).inner} = ${x.text}`,
    );
  });
  if (met.length === 0) return lines;
  return [
    ...lines,
    ...first(numbers, 'min x', least(met)),
    ...last(numbers, 'max x', greatest(met)),
  ];
}

/**
 * A calculation in which the operands have the listing's symbols, or words of the language, instead of the trace's names.
 * `other` is the symbol of the depth that z is compared with.
 */
export function inNotation(line: string, language: Language, other = 'z₀'): string {
  const { upper, lower } = texts[language].curves;
  const names = new Map([
    ['against', other],
    ['left', 'x₁'],
    ['right', 'x₂'],
    ['upper', upper],
    ['lower', lower],
  ]);
  return line.replace(/\b[a-z]+\b/gu, (name) => names.get(name) ?? name);
}

/** A number of a trace, whole ones without a denominator. */
export const withoutOne = (text: string): string => text.replace(/\/1$/u, '');

/** A whole number as an exponent. */
export const superscript = (exponent: number): string =>
  String(exponent).replace(/[\d-]/gu, (sign) =>
    sign === '-' ? '⁻' : ('⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)] ?? ''),
  );
