import type { Language } from '../../language/language.js';
import type { N } from '../../trace/values.js';
import type { Fact } from './fact.js';

/** A number of a trace, computed independently of the page. */
export function value(n: N): number {
  if (typeof n === 'number') return n;
  if (n.endsWith('inf')) return n.startsWith('-') ? -Infinity : Infinity;
  const [above = '', below = '1'] = n.split('/');
  if (!/^-?\d+$/.test(above) || below === '0') return NaN;
  return Number(`${(BigInt(above) * 10n ** 60n) / BigInt(below)}e-60`);
}

/** The order of two numbers of a trace, fractions exactly: -1, 0 or 1; NaN if there is none. */
export function orderOfNumbers(a: N, b: N): number {
  const whole = /^-?\d+\/[1-9]\d*$/;
  if (typeof a !== 'string' || typeof b !== 'string' || !whole.test(a) || !whole.test(b)) {
    return value(a) === value(b) ? 0 : Math.sign(value(a) - value(b));
  }
  const [[p = 0n, q = 1n], [r = 0n, s = 1n]] = [a, b].map((each) =>
    each.split('/').map(BigInt),
  ) as [bigint[], bigint[]];
  return p * s === r * q ? 0 : p * s > r * q ? 1 : -1;
}

const number =
  /(?<![\p{L}\d])(?:≈ ?)?[−+]?(?:∞|nan|\d+(?:[.,]\d+)?(?:e[+−-]?\d+)?(?:\/\d+)?)(?![\p{L}\d])/giu;

/** A number in a sentence, and its possible error. */
interface Shown {
  readonly value: number;
  readonly off: number;
}

function shown(text: string): Shown {
  const isCut = text.startsWith('≈');
  const plain = text
    .replace(/≈ ?|\+/u, '')
    .replaceAll('−', '-')
    .replace('∞', 'inf')
    .replace(',', '.');
  if (plain.includes('/') || /inf|nan/iu.test(plain)) return { value: value(plain), off: 1e-15 };
  const [, decimals = '', power = '0'] = /^-?\d+(?:\.(\d+))?(?:e(.*))?$/u.exec(plain) ?? [];
  return {
    value: Number(plain),
    off: isCut ? 0.5001 * 10 ** (Number(power) - decimals.length) : 0,
  };
}

/** NaN comes last. */
const rising = (a: number, b: number): number =>
  a < b || Number.isNaN(b) ? -1 : a > b || Number.isNaN(a) ? 1 : 0;

/** A number without the mark of a shortened one is exact. A number that is nearly whole looks whole at four digits. */
function isOf({ value: shown, off }: Shown, right: number): boolean {
  if (Object.is(shown, right) || shown === right) return true;
  return off > 0 && Math.abs(shown - right) <= Math.max(off, 0.0005 * Math.abs(shown));
}

/** Whether these numbers are stated. Both are rising. Exact numbers come first, since a shortened one may look like one of them. */
function areThese(stated: readonly Shown[], right: readonly number[]): boolean {
  const rest = [...right];
  for (const exact of stated.filter(({ off }) => off === 0)) {
    const place = rest.findIndex((each) => isOf(exact, each));
    if (place < 0) return false;
    rest.splice(place, 1);
  }
  const others = stated.filter(({ off }) => off > 0);
  return others.length === rest.length && others.every((each, i) => isOf(each, rest[i] ?? NaN));
}

/** What is wrong with the form of a sentence; null if it is one sentence without the traces of a missing value. */
export function faultOfForm(sentence: string): string | null {
  if (!/^[\p{Lu}\d].*[.?]$/u.test(sentence)) return 'is not one sentence';
  const hole = /undefined|null|NaN|\[object|[{}]|\s\s| \./u.exec(sentence);
  return hole === null ? null : `has “${hole[0]}”`;
}

/** The error in a sentence that should state this, in words; null if there is none. */
export function faultOf(
  sentence: string,
  { ids = [], numbers = [], says = [] }: Fact,
  all: readonly string[],
  language: Language,
): string | null {
  const form = faultOfForm(sentence);
  if (form !== null) return form;
  const found = all.filter((id) => sentence.includes(id));
  const expected = all.filter((id) => ids.includes(id));
  if (found.join() !== expected.join()) return `names ${found.join()}, not ${expected.join()}`;
  const texts = [...sentence.matchAll(number)].map(([text]) => text);
  const foreign = texts.find((text) => text.includes(language === 'ru' ? '.' : ','));
  if (foreign !== undefined) return `writes ${foreign} as another language does`;
  const stated = texts.map(shown).sort((a, b) => rising(a.value, b.value));
  const right = numbers.map(value).sort(rising);
  if (!areThese(stated, right))
    return `states ${stated.map((each) => each.value).join(' ')}, not ${right.join(' ')}`;
  const missing = says.find((each) => !each[language].test(sentence));
  return missing === undefined ? null : `does not say ${String(missing[language])}`;
}
