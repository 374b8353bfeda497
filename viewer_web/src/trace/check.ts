import { Refusal, describe } from './refusal.js';

/** Takes an unknown value and gives it back with its type, or refuses it. */
export type Check<T> = (value: unknown, path: string) => T;
export type Checked<C> = C extends Check<infer T> ? T : never;

type Fields = Readonly<Record<string, Check<unknown>>>;
export type Obligatory<F> = { readonly [K in keyof F]: Checked<F[K]> };
export type Optional<F> = { readonly [K in keyof F]?: Checked<F[K]> };

const child = (path: string, key: string): string => (path === '' ? key : `${path}.${key}`);

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

export function between(least: number, greatest: number): Check<number> {
  return (value, path) => {
    const n = whole(value, path);
    if (n >= least && n <= greatest) return n;
    throw new Refusal(path, 'between', String(least), String(greatest), describe(value));
  };
}

export function oneOf<const T extends string | number | boolean>(
  ...values: readonly T[]
): Check<T> {
  return (value, path) => {
    if (values.includes(value as T)) return value as T;
    throw new Refusal(path, 'oneOf', values.join(', '), describe(value));
  };
}

export function matching(
  pattern: RegExp,
  otherwise: 'color' | 'label' | 'hash' | 'kernel',
): Check<string> {
  return (value, path) => {
    if (typeof value === 'string' && pattern.test(value)) return value;
    throw new Refusal(path, otherwise, describe(value));
  };
}

export function list<T>(item: Check<T>): Check<readonly T[]> {
  return (value, path) => {
    if (!Array.isArray(value)) throw new Refusal(path, 'list', describe(value));
    return value.map((each, i) => item(each, `${path}[${i}]`));
  };
}

/** What one of the checks takes: the answer to a decision. */
export function either<const C extends readonly Check<unknown>[]>(
  ...checks: C
): Check<Checked<C[number]>> {
  return (value, path) => {
    for (const check of checks) {
      try {
        return check(value, path) as Checked<C[number]>;
      } catch (refusal) {
        if (!(refusal instanceof Refusal)) throw refusal;
      }
    }
    throw new Refusal(path, 'answer', describe(value));
  };
}

type Tuple<C extends readonly Check<unknown>[]> = { readonly [I in keyof C]: Checked<C[I]> };

export function tuple<const C extends readonly Check<unknown>[]>(...items: C): Check<Tuple<C>> {
  return (value, path) => {
    if (!Array.isArray(value) || value.length !== items.length) {
      throw new Refusal(path, 'listOf', String(items.length), describe(value));
    }
    return items.map((item, i) => item(value[i], `${path}[${i}]`)) as unknown as Tuple<C>;
  };
}

export function plainObject(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) {
    return value as Readonly<Record<string, unknown>>;
  }
  throw new Refusal(path, 'object', describe(value));
}

/** An object with these fields at least; others are left out. */
export function part<F extends Fields>(fields: F): Check<Obligatory<F>> {
  return (value, path) => {
    const object = plainObject(value, path);
    const entries = Object.entries(fields).map(([key, check]) => {
      if (!Object.hasOwn(object, key)) throw new Refusal(child(path, key), 'missing');
      return [key, check(object[key], child(path, key))] as const;
    });
    return Object.fromEntries(entries) as Obligatory<F>;
  };
}

/** An object with exactly these fields: none missing, none unknown. */
export function record<F extends Fields, O extends Fields>(
  fields: F,
  optional: O,
): Check<Obligatory<F> & Optional<O>> {
  const checks: Fields = { ...fields, ...optional };
  return (value, path) => {
    const object = plainObject(value, path);
    const result: Record<string, unknown> = {};
    for (const [key, inside] of Object.entries(object)) {
      const check = Object.hasOwn(checks, key) ? checks[key] : undefined;
      if (check === undefined) throw new Refusal(child(path, key), 'unknownKey');
      result[key] = check(inside, child(path, key));
    }
    for (const key of Object.keys(fields)) {
      if (!Object.hasOwn(result, key)) throw new Refusal(child(path, key), 'missing');
    }
    return result as Obligatory<F> & Optional<O>;
  };
}
