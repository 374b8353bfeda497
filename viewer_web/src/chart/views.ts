import { kinds } from './format.js';
import type { Chart, Kind, Subject } from './format.js';
import { kindOf, subjectsOf } from './subject.js';

/** A view of the chart: one subject, or all subjects of a kind together. */
export interface View {
  /** Its name in the page's address. */
  readonly id: string;
  readonly kind: Kind;
  /** The name of the subject; null for all of the kind. */
  readonly name: string | null;
  readonly subjects: readonly Subject[];
}

/** Subjects with unique names: the second one of the same name gets `(2)`. */
function named(subjects: readonly Subject[]): readonly (readonly [string, Subject])[] {
  const seen = new Map<string, number>();
  return subjects.map((subject) => {
    const { name } = subject;
    const times = (seen.get(name) ?? 0) + 1;
    seen.set(name, times);
    return [times === 1 ? name : `${name} (${times})`, subject];
  });
}

export function viewsOf(chart: Chart): readonly View[] {
  return kinds.flatMap((kind): readonly View[] => {
    const subjects = subjectsOf(chart).filter((subject) => kindOf(subject) === kind);
    const single = named(subjects).map(([name, subject]) => ({
      id: `${kind}/${name}`,
      kind,
      name,
      subjects: [subject],
    }));
    return subjects.length < 2 ? single : [{ id: kind, kind, name: null, subjects }, ...single];
  });
}
