import { countedIn, texts } from '../i18n/index.js';
import type { NodeData, Outlined } from '../outline/outlined.js';
import { cases } from '../time/course.js';
import type { Case } from '../time/course.js';
import { sayWindow } from '../time/place.js';
import type { EventName } from '../trace/events.js';

/** The events whose last one in a window names the visible polygon. */
const showing: Readonly<Partial<Record<Case, readonly EventName[]>>> = {
  surrounded: ['cover', 'hiding'],
  pixel: ['nearest'],
  single: ['draw'],
};

function shownIn({ stepsOf, event }: NodeData, which: Case | undefined): string | null {
  const names = which === undefined ? [] : (showing[which] ?? []);
  const last = Math.max(0, ...names.flatMap((name) => stepsOf(name)));
  const found = event(last);
  return found !== null && 'polygon' in found ? (found.polygon ?? null) : null;
}

/** The windows, each nested in the one that was divided. */
export const outline: Outlined = {
  parts: [],
  say(node, language) {
    const { kind, first, last, part, event } = node;
    const { strip, numbers, outline: say } = texts[language];
    if (kind === 'ProcessWindow') {
      const summary = event(last);
      return summary?.e === 'summary'
        ? `ProcessWindow: ${countedIn(language, summary.count, say.polygons)}`
        : null;
    }
    const begins = event(first);
    if (begins?.e !== 'pop') return null;
    const window = sayWindow(begins.window, { strip, numbers });
    const which = cases[part];
    const shown = shownIn(node, which);
    const comes =
      which === undefined ? [] : [strip.cases[which], ...(shown === null ? [] : [shown])];
    return comes.length === 0 ? window : `${window}: ${comes.join(', ')}`;
  },
};
