import { countedIn, texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { short } from '../language/words.js';
import type { NodeData, Outlined } from '../outline/outlined.js';
import { details, kinds } from '../trace/events.js';
import type { Event } from '../trace/events.js';

const rowOf = (event: Event | null): number | null => (event?.e === 'scanline' ? event.row : null);

function sayPolygon({ header, part, event, stepsOf }: NodeData, language: Language): string {
  const { strip, outline: say } = texts[language];
  const steps = stepsOf('scanline');
  const [first, last] = [rowOf(event(steps[0] ?? 0)), rowOf(event(steps.at(-1) ?? 0))];
  const rows = first === null || last === null ? say.noRows : say.rows(short(first), short(last));
  return `${strip.polygon(header.scene.polygons[part]?.id ?? '')}: ${rows}`;
}

/** The number of active edges when a row is shown; null if the trace does not record what joins the AEL. */
function activeIn({ header, first, itemFrom, stepsOf, event }: NodeData): number | null {
  if (details.indexOf(header.detail) < details.indexOf(kinds.ael_add.from)) return null;
  const gone = stepsOf('ael_drop', itemFrom)
    .filter((step) => step < first)
    .map((step) => event(step))
    .reduce((sum, each) => sum + (each?.e === 'ael_drop' ? each.edges.length : 0), 0);
  return stepsOf('ael_add', itemFrom).length - gone;
}

function sayRow(node: NodeData, language: Language): string | null {
  const { strip, outline: say } = texts[language];
  const row = rowOf(node.event(node.first));
  if (row === null) return null;
  const active = activeIn(node);
  const edges = active === null ? [] : [countedIn(language, active, say.edges)];
  const spans = countedIn(language, node.stepsOf('span').length, say.spans);
  return `${strip.row(short(row))}: ${[...edges, spans].join(', ')}`;
}

/** The polygons, each with its rows. */
export const outline: Outlined = {
  parts: ['scanline'],
  numberOf: rowOf,
  say(node, language) {
    if (node.kind === 'item') return sayPolygon(node, language);
    return node.kind === 'part' ? sayRow(node, language) : null;
  },
};
