/** The words with the values in place of each `{}`. */
export function filled(words: string, ...values: readonly string[]): string {
  const [first = '', ...others] = words.split('{}');
  return first + others.map((part, i) => `${values[i] ?? ''}${part}`).join('');
}

/** The values in place of each `{}` of the words; null if the text does not consist of these words. */
export function valuesIn(words: string, text: string): readonly string[] | null {
  const parts = words.split('{}').map((part) => part.replace(/[\\^$.*+?()[\]{}|]/gu, '\\$&'));
  const match = new RegExp(`^${parts.join('(.+?)')}$`, 'su').exec(text);
  return match?.slice(1) ?? null;
}
