import type { Header } from '../trace/header.js';
import type { Box, Corner, N } from '../trace/values.js';
import type { Numbers, Phrases, Texts } from './texts.js';

const shortest = 7;
const longest = 40;

/** A whole fraction's value, near enough to be shown. */
function fractionValue(written: string): number {
  const [above = '0', below = '1'] = written.split('/');
  const scale = 10n ** 12n;
  return Number((BigInt(above) * scale) / BigInt(below)) / 1e12;
}

/** The digits of a number that are shown; if these are not all, there is room for `≈`. */
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

/** A number of a trace as it is shown: short, with a real minus sign; `≈` where that is not all of it. */
export function short(value: N): string {
  return plain(value).replaceAll('-', '−');
}

/** A text in which `x = ≈0.3` is `x ≈ 0.3`. */
export const withoutDoubledSigns = (text: string): string => text.replaceAll('= ≈', '≈ ');

/** A whole number that is added. */
export const signed = (n: number): string => (n > 0 ? `+${n}` : short(n));

/** Two numbers that are compared: in full where they are not the same and would look so. */
export function shortApart(a: N, b: N): readonly [string, string] {
  const looks = [short(a), short(b)] as const;
  return looks[0] === looks[1] && a !== b ? [inFull(a), inFull(b)] : looks;
}

/** All of a number, however long. */
export const whole = (value: N): string => String(value).replaceAll('-', '−').replace('inf', '∞');

/** Fractions may be longer than any sentence. */
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

/** The number to plot, where there is one. */
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

/** How a number compares with another: -1, 0 or 1; null where neither is less, equal or greater. */
export function orderOf(a: N, b: N): -1 | 0 | 1 | null {
  const [one, other] = [a, b].map((value) =>
    typeof value === 'string' ? asFraction(value) : null,
  );
  const difference =
    one && other ? one[0] * other[1] - other[0] * one[1] : comparable(toNumber(a), toNumber(b));
  if (difference > 0) return 1;
  if (difference < 0) return -1;
  return difference == 0 ? 0 : null;
}

/** Their difference, of infinities too. */
const comparable = (a: number, b: number): number => (a === b ? 0 : a - b);

/** Texts with numbers in them, one after the other. */
export const joined = (all: readonly string[]): string => all.join(', ');

export const list = (all: readonly N[], write = short): string =>
  joined(all.map((each) => write(each)));

export const point = (at: readonly N[]): string => `(${list(at)})`;

/** Whole numbers from one to another, where a dash may stand between them. */
export function rangeOf(first: number, last: number): string {
  if (first === last) return short(first);
  return `${short(first)}${first < 0 ? '…' : '–'}${short(last)}`;
}

export function windowText([x, y, width, height]: Box): string {
  return `${point([x, y])} ${short(width)} × ${short(height)}`;
}

export interface PluralForms {
  readonly one: string;
  readonly few?: string;
  readonly other: string;
}

/**
 * What of a step's values the sentences use, each algorithm's under a name of its own. The algorithms add their parts by
 * `declare module`.
 */
// eslint-disable-next-line @typescript-eslint/no-empty-object-type
export interface Known {}

/** "3 pixels", "3 пикселя". */
export function counted(n: number, forms: PluralForms, rules: Intl.PluralRules): string {
  const form = rules.select(n);
  if (form === 'one') return `${n} ${forms.one}`;
  return `${n} ${form === 'few' ? (forms.few ?? forms.other) : forms.other}`;
}

/** What of a header the sentences use. */
export type ShownHeader = Pick<Header, 'method' | 'scene' | 'detail' | 'edition'>;

/** What the sentences of a step need beside its event. */
export class Words {
  constructor(
    readonly before: Known,
    readonly after: Known,
    readonly header: ShownHeader,
    readonly texts: Texts,
    private readonly rules: Intl.PluralRules,
  ) {}

  get short(): Numbers['short'] {
    return this.texts.numbers.short;
  }

  get shortApart(): Numbers['shortApart'] {
    return this.texts.numbers.shortApart;
  }

  get signed(): Numbers['signed'] {
    return this.texts.numbers.signed;
  }

  get point(): Numbers['point'] {
    return this.texts.numbers.point;
  }

  get windowText(): Numbers['windowText'] {
    return this.texts.numbers.windowText;
  }

  get columnsOf(): Phrases['columnsOf'] {
    return this.texts.phrases.columnsOf;
  }

  readonly takes = (n: number): string => this.texts.phrases.takes(n, this);

  counted(n: number, forms: PluralForms): string {
    return counted(n, forms, this.rules);
  }

  places(corners: readonly Corner[]): string {
    return corners.map((corner) => this.texts.places[corner]).join(', ');
  }

  ids(ids: readonly string[]): string {
    const most = 6;
    const shown = ids.slice(0, most).join(', ');
    return ids.length > most ? `${shown} … (${ids.length})` : shown;
  }

  list(edges: readonly number[]): string {
    return edges.join(', ');
  }
}

/** "1", "1 and 0", "2, 1 and 0". */
export const listed = (all: readonly (string | number)[], and: string): string =>
  [all.slice(0, -1).join(', '), all.slice(-1).join('')].filter(Boolean).join(` ${and} `);

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

export function cells(runs: readonly (readonly number[])[]): number {
  return runs.reduce((sum, run) => sum + (run.at(-1) ?? 0) - (run.at(-2) ?? 0), 0);
}
