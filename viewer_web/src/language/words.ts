import type { Box, N } from '../trace/values.js';

const shortest = 7;
const longest = 40;

/** The approximate value of a fraction, for display. */
function fractionValue(written: string): number {
  const [above = '0', below = '1'] = written.split('/');
  const scale = 10n ** 12n;
  return Number((BigInt(above) * scale) / BigInt(below)) / 1e12;
}

/** The displayed digits of a number. If these are not all, there is room for `≈`. */
function rounded(value: number): string {
  const exact = String(value);
  if (exact.length <= shortest) return exact;
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) return value.toExponential(2);
  const texts = [4, 3, 2].map((digits) => String(Number(value.toPrecision(digits))));
  return texts.find((text) => text.length < shortest) ?? value.toPrecision(2);
}

function shortNumber(value: number): string {
  const text = rounded(value);
  return Number(text) === value || Number.isNaN(value) ? text : `≈${text}`;
}

/** The displayed form of a number of a trace: short, with a real minus sign, and with `≈` if digits are missing. */
export function short(value: N): string {
  return plain(value).replaceAll('-', '−');
}

/** Replaces `x = ≈0.3` by `x ≈ 0.3`. */
export const withoutDoubledSigns = (text: string): string => text.replaceAll('= ≈', '≈ ');

/** A whole number as an exponent. */
export const superscript = (exponent: number): string =>
  String(exponent).replace(/[\d-]/gu, (sign) =>
    sign === '-' ? '⁻' : ('⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)] ?? ''),
  );

/** A whole number with its sign, as a summand. */
export const signed = (n: number): string => (n > 0 ? `+${n}` : short(n));

/** Two numbers to compare, in full if they differ but their short forms do not. */
export function shortApart(a: N, b: N): readonly [string, string] {
  const looks = [short(a), short(b)] as const;
  return looks[0] === looks[1] && a !== b ? [inFull(a), inFull(b)] : looks;
}

/** The mark of a shortened number, also for one that is not exact. */
export const approximately = (shortened: string): string =>
  shortened.startsWith('≈') ? shortened : `≈${shortened}`;

/** A number with all its digits. */
export const whole = (value: N): string => String(value).replaceAll('-', '−').replace('inf', '∞');

/** A number in full, up to a length: fractions may be too long for a sentence. */
export function inFull(value: N): string {
  const text = whole(value);
  return text.length > longest ? short(value) : text;
}

function plain(value: N): string {
  if (typeof value === 'number') return shortNumber(value);
  if (value.endsWith('inf')) return value.replace('inf', '∞');
  if (value.endsWith('/1')) return value.slice(0, -2);
  if (value === 'nan' || value.length <= shortest) return value;
  if (value.endsWith('/0')) return value;
  return `≈${rounded(fractionValue(value))}`;
}

/** The number to plot, or NaN. */
export function toNumber(value: N): number {
  if (typeof value === 'number') return value;
  if (value === 'inf') return Infinity;
  if (value === '-inf') return -Infinity;
  return value === 'nan' || value.endsWith('/0') ? NaN : fractionValue(value);
}

function asFraction(value: string): readonly [bigint, bigint] | null {
  const [, above, below] = /^(-?\d+)\/(\d+)$/.exec(value) ?? [];
  if (above === undefined || below === undefined || below === '0') return null;
  return [BigInt(above), BigInt(below)];
}

/** The order of one number relative to another. */
export type Order = -1 | 0 | 1;
export const relationBy = { '-1': '<', 0: '=', 1: '>' } as const satisfies Record<Order, string>;
export type Relation = (typeof relationBy)[Order];

/** The order of one number relative to another; null if they cannot be compared. */
export function orderOf(a: N, b: N): Order | null {
  const [one, other] = [a, b].map((value) =>
    typeof value === 'string' ? asFraction(value) : null,
  );
  const difference =
    one && other ? one[0] * other[1] - other[0] * one[1] : comparable(toNumber(a), toNumber(b));
  if (difference > 0) return 1;
  if (difference < 0) return -1;
  return difference == 0 ? 0 : null;
}

/** The difference of two numbers, also of infinities. */
const comparable = (a: number, b: number): number => (a === b ? 0 : a - b);

/** Several texts with numbers, separated by commas. */
export const joined = (all: readonly string[]): string => all.join(', ');

export const list = (all: readonly N[], write = short): string =>
  joined(all.map((each) => write(each)));

export const point = (at: readonly N[]): string => `(${list(at)})`;

export function windowText([x, y, width, height]: Box): string {
  return `${point([x, y])} ${short(width)} × ${short(height)}`;
}

export interface PluralForms {
  readonly one: string;
  readonly few?: string;
  readonly other: string;
}

/** "3 pixels", "3 пикселя". */
export function counted(n: number, forms: PluralForms, rules: Intl.PluralRules): string {
  const form = rules.select(n);
  if (form === 'one') return `${n} ${forms.one}`;
  return `${n} ${form === 'few' ? (forms.few ?? forms.other) : forms.other}`;
}

export function cells(runs: readonly (readonly number[])[]): number {
  return runs.reduce((sum, run) => sum + (run.at(-1) ?? 0) - (run.at(-2) ?? 0), 0);
}
