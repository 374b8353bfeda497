import { countedIn, texts } from '../i18n/index.js';
import type { Outlined } from '../outline/outlined.js';

/** The curves. */
export const outline: Outlined = {
  parts: [],
  say({ kind, part, stepsOf }, language) {
    if (kind !== 'item') return null;
    const { curves, outline: say } = texts[language];
    const lines = stepsOf('draw_line').length;
    const seen = lines === 0 ? say.hidden : countedIn(language, lines, say.lines);
    return `${curves.curve(part).toLowerCase()}: ${seen}`;
  },
};
