import { Refusal, describe } from './refusal.js';

/** Checks an unknown value, and returns it with its type or throws. */
export interface Check<T> {
  (value: unknown, path: string): T;
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

export function optional<T>(check: Check<T>): OptionalCheck<T> {
  const take: Check<T> = (value, path) => check(value, path);
  return Object.assign(take, { optional: true } as const);
}

/** The value of a text in JSON. */
export function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    const isEmpty = text.trim() === '';
    throw isEmpty ? new Refusal('', 'emptyFile') : new Refusal('', 'notJson', describe(text));
  }
}

export const bool: Check<boolean> = (value, path) => {
  if (typeof value === 'boolean') return value;
  throw new Refusal(path, 'bool', describe(value));
};

export const text: Check<string> = (value, path) => {
  if (typeof value === 'string') return value;
  throw new Refusal(path, 'text', describe(value));
};

export const finite: Check<number> = (value, path) => {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  throw new Refusal(path, 'number', describe(value));
};

export const whole: Check<number> = (value, path) => {
  if (typeof value === 'number' && Number.isSafeInteger(value)) return value;
  throw new Refusal(path, 'whole', describe(value));
};

export const count: Check<number> = (value, path) => inRange(value, path, 0);

export const between =
  (least: number, greatest: number): Check<number> =>
  (value, path) =>
    inRange(value, path, least, greatest);

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
  return (value, path) => {
    if (values.includes(value as T)) return value as T;
    throw new Refusal(path, 'oneOf', values.join(', '), describe(value));
  };
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

export function list<T>(item: Check<T>): Check<readonly T[]> {
  return (value, path) => {
    if (!Array.isArray(value)) throw new Refusal(path, 'list', describe(value));
    return value.map((inside, i) => item(inside, `${path}[${i}]`));
  };
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
