import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import type { Fact } from '../predict/facts.js';

/** The current scanline. */
export function facts({ after, language }: View): readonly Fact[] {
  const { y } = after.zbuffer ?? {};
  return y == null ? [] : [['yₜ', texts[language].numbers.short(y)]];
}

export const polygonsAsked = (_view: View, named: string | null): readonly string[] =>
  named === null ? [] : [named];
