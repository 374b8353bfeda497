import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { NodeData, Outlined } from '../outline/outlined.js';

const mostNamed = 4;

/** The result of a list: its clip polygon is visible, or these polygons are in front of it, and it is put after them. */
function outcome({ event, stepsOf }: NodeData, language: Language): string | null {
  const { visible, inFront } = texts[language].outline;
  if (stepsOf('show').length > 0) return visible;
  const again = stepsOf('push_list')
    .map((step) => event(step))
    .find((each) => each?.at === 'WA9');
  if (again?.e !== 'push_list') return null;
  const nearer = again.pieces.slice(0, -1).map(([polygon]) => polygon);
  const named = [...new Set(nearer)];
  const more = named.length > mostNamed ? ' …' : '';
  return inFront(named.slice(0, mostNamed).join(', ') + more);
}

/** The lists. A list of inside parts that is tried again is nested in the list that the parts come from. */
export const outline: Outlined = {
  parts: [],
  say(node, language) {
    const begins = node.event(node.first);
    if (node.kind !== 'item' || begins?.e !== 'pop_list') return null;
    const say = texts[language].outline;
    const list = say.list(begins.count, begins.clip);
    const came = outcome(node, language);
    return came === null ? list : `${list}: ${came}`;
  },
};
