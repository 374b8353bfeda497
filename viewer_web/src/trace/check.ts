import { Refusal, describe } from './refusal.js';

/** Checks an unknown value, and returns it with its type or throws. */
export interface Check<T> {
  (value: unknown, path: string): T;
  /**
   * A regular expression of JSON texts that the check certainly accepts, including all that a run writes. Values of a check
   * without one are always parsed.
   */
  readonly plain?: string;
  /** A field that may be missing. */
  readonly optional?: true;
}
export type Checked<C> = C extends Check<infer T> ? T : never;
type OptionalCheck<T> = Check<T> & { readonly optional: true };

export type Fields = Readonly<Record<string, Check<unknown>>>;
type Obligatory<F> = {
  readonly [K in keyof F as F[K] extends OptionalCheck<unknown> ? never : K]: Checked<F[K]>;
};
type Optional<F> = {
  readonly [K in keyof F as F[K] extends OptionalCheck<unknown> ? K : never]?: Checked<F[K]>;
};
/** An object with these fields, the optional ones maybe. */
export type Recorded<F> = Obligatory<F> & Optional<F>;

const child = (path: string, key: string): string => (path === '' ? key : `${path}.${key}`);

const nothing = '(?!)';

export const plainOf = ({ plain }: Check<unknown>): string => plain ?? nothing;

/** A check with the plain form of the values that it accepts. */
export function written<T>(plain: string, take: (value: unknown, path: string) => T): Check<T> {
  return Object.assign(take, { plain });
}

export function optional<T>(check: Check<T>): OptionalCheck<T> {
  const take: Check<T> = (value, path) => check(value, path);
  return Object.assign(take, { plain: plainOf(check), optional: true } as const);
}

/** The limited number of digits makes numbers finite, and whole numbers safe. */
const natural = '(?:0|[1-9]\\d{0,14})';
const integer = `-?${natural}`;
export const plainNumber = `${integer}(?:\\.\\d{1,20})?(?:e[+-]?\\d{1,2})?`;
export const plainText = '"[^"\\\\\\x00-\\x1f]*"';

export const bool = written('(?:true|false)', (value, path) => {
  if (typeof value === 'boolean') return value;
  throw new Refusal(path, 'bool', describe(value));
});

export const text = written(plainText, (value, path) => {
  if (typeof value === 'string') return value;
  throw new Refusal(path, 'text', describe(value));
});

export const finite = written(plainNumber, (value, path) => {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  throw new Refusal(path, 'number', describe(value));
});

export const whole = written(integer, (value, path) => {
  if (typeof value === 'number' && Number.isSafeInteger(value)) return value;
  throw new Refusal(path, 'whole', describe(value));
});

export const count = written(natural, (value, path) => inRange(value, path, 0));

export function between(least: number, greatest: number): Check<number> {
  const isOfDigits = least >= -9 && greatest <= 9 && greatest >= 0;
  const negative = least < 0 ? `|-[1-${-least}]` : '';
  const digits = `(?:[${Math.max(0, least)}-${greatest}]${negative})`;
  return written(isOfDigits ? digits : nothing, (value, path) =>
    inRange(value, path, least, greatest),
  );
}

function inRange(
  value: unknown,
  path: string,
  least: number,
  greatest = Number.MAX_SAFE_INTEGER,
): number {
  const n = whole(value, path);
  if (n >= least && n <= greatest) return n;
  throw new Refusal(path, 'between', String(least), String(greatest), describe(value));
}

export function oneOf<const T extends string | number | boolean>(
  ...values: readonly T[]
): Check<T> {
  return written(anyOf(values.map((value) => JSON.stringify(value))), (value, path) => {
    if (values.includes(value as T)) return value as T;
    throw new Refusal(path, 'oneOf', values.join(', '), describe(value));
  });
}

const versioned = /^vidno-[a-z]+\/(\d+)$/;

/** The format of a file. A file of another version gets advice. */
export function formatOf<const T extends string>(format: T): Check<T> {
  const check = oneOf(format);
  const version = (name: string): number => Number(versioned.exec(name)?.[1] ?? NaN);
  return (value, path) => {
    const said = String(value);
    const [found, known] = [version(said), version(format)];
    if (found > known) throw new Refusal(path, 'newerFormat', format, said);
    if (found < known) throw new Refusal(path, 'olderFormat', format, said);
    return check(value, path);
  };
}

const anyOf = (plain: readonly string[]): string => `(?:${plain.join('|')})`;

/** An ASCII text that matches the pattern from `^` to `$`. */
export function matching(
  pattern: RegExp,
  otherwise: 'color' | 'label' | 'hash' | 'kernel',
): Check<string> {
  return written(`"${pattern.source.slice(1, -1)}"`, (value, path) => {
    if (typeof value === 'string' && pattern.test(value)) return value;
    throw new Refusal(path, otherwise, describe(value));
  });
}

export function list<T>(item: Check<T>): Check<readonly T[]> {
  const each = plainOf(item);
  return written(`\\[(?:${each}(?:,${each})*)?\\]`, (value, path) => {
    if (!Array.isArray(value)) throw new Refusal(path, 'list', describe(value));
    return value.map((inside, i) => item(inside, `${path}[${i}]`));
  });
}

/** A value that one of the checks accepts, such as the answer to a decision. */
export function either<const C extends readonly Check<unknown>[]>(
  ...checks: C
): Check<Checked<C[number]>> {
  return written(anyOf(checks.map(plainOf)), (value, path) => {
    for (const check of checks) {
      try {
        return check(value, path) as Checked<C[number]>;
      } catch (refusal) {
        if (!(refusal instanceof Refusal)) throw refusal;
      }
    }
    throw new Refusal(path, 'answer', describe(value));
  });
}

type Tuple<C extends readonly Check<unknown>[]> = { readonly [I in keyof C]: Checked<C[I]> };

export function tuple<const C extends readonly Check<unknown>[]>(...items: C): Check<Tuple<C>> {
  return written(`\\[${items.map(plainOf).join(',')}\\]`, (value, path) => {
    if (!Array.isArray(value) || value.length !== items.length) {
      throw new Refusal(path, 'listOf', String(items.length), describe(value));
    }
    return items.map((item, i) => item(value[i], `${path}[${i}]`)) as unknown as Tuple<C>;
  });
}

type Members = Readonly<Record<string, unknown>>;

export function plainObject(value: unknown, path: string): Members {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) {
    return value as Members;
  }
  throw new Refusal(path, 'object', describe(value));
}

/** An object whose format is right, if it has one: a file of another version may have other fields. */
function objectFor({ format }: Fields, value: unknown, path: string): Members {
  const object = plainObject(value, path);
  if ('format' in object) format?.(object['format'], child(path, 'format'));
  return object;
}

/** An object with at least these fields, except optional ones; other fields are dropped. */
export function part<F extends Fields>(fields: F): Check<Recorded<F>> {
  return (value, path) => {
    const object = objectFor(fields, value, path);
    const result: Record<string, unknown> = {};
    for (const [key, check] of Object.entries(fields)) {
      if (Object.hasOwn(object, key)) result[key] = check(object[key], child(path, key));
      else if (check.optional !== true) throw new Refusal(child(path, key), 'missing');
    }
    return result as Recorded<F>;
  };
}

/** An object with arbitrary field names, whose values have the same type. */
export function dictionary<T>(check: Check<T>): Check<ReadonlyMap<string, T>> {
  return (value, path) => {
    const fields = Object.entries(plainObject(value, path));
    return new Map(fields.map(([key, inside]) => [key, check(inside, child(path, key))]));
  };
}

type Kinds = Readonly<Record<string, Fields>>;
/** An object with the fields of the kind that `is` names. */
export type OneKind<K extends Kinds> = {
  readonly [N in keyof K & string]: Recorded<K[N]> & { readonly is: N };
}[keyof K & string];

/** An object with at least the fields of the kind that its field `is` names; other fields are dropped. */
export function oneKind<const K extends Kinds>(kinds: K): Check<OneKind<K>> {
  const kind = part({ is: oneOf(...Object.keys(kinds)) });
  const checks = new Map(Object.entries(kinds).map(([is, fields]) => [is, part(fields)]));
  return (value, path) => {
    const { is } = kind(value, path);
    return { is, ...checks.get(is)?.(value, path) } as OneKind<K>;
  };
}

/** An object with exactly these fields, except optional ones. Unknown fields are refused. */
export function record<F extends Fields>(fields: F): Check<Recorded<F>> {
  const needed = Object.entries(fields).filter(([, { optional: may }]) => may !== true);
  return (value, path) => {
    const object = objectFor(fields, value, path);
    const result: Record<string, unknown> = {};
    for (const [key, inside] of Object.entries(object)) {
      const check = Object.hasOwn(fields, key) ? fields[key] : undefined;
      if (check === undefined) throw new Refusal(child(path, key), 'unknownKey');
      result[key] = check(inside, child(path, key));
    }
    for (const [key] of needed) {
      if (!Object.hasOwn(result, key)) throw new Refusal(child(path, key), 'missing');
    }
    return result as Recorded<F>;
  };
}
