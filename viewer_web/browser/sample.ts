/** All of them; where `CI` is set, one in `n`, since its minutes are counted. */
export function sample<T>(all: readonly T[], n: number): readonly T[] {
  return process.env['CI'] === undefined ? all : all.filter((_, i) => i % n === 0);
}
