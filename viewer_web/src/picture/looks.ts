import { tokens } from '../elements/theme.js';
import { curvesStyle } from './curves.style.js';
import { marksStyle } from './marks.style.js';
import { pictureStyle } from './picture.style.js';
import { regionsStyle } from './regions.style.js';

/** Declarations for what has all of some classes. */
interface Rule {
  readonly classes: readonly string[];
  readonly declarations: readonly (readonly [name: string, value: string])[];
}

/** What of a look becomes an attribute; the lengths are in CSS pixels. */
const lengths = ['stroke-width', 'stroke-dasharray'];
const attributes = [
  'fill',
  'fill-opacity',
  'stroke',
  'stroke-opacity',
  'stroke-linejoin',
  'stroke-linecap',
  ...lengths,
];

const sheet =
  marksStyle.cssText + pictureStyle.cssText + curvesStyle.cssText + regionsStyle.cssText;

/** Those of the page's own are as in the light theme: the marks are alike in both. */
const variables = new Map(
  [...`${sheet}${tokens.cssText}`.matchAll(/(--[\w-]+):\s*([^;]+);/g)]
    .reverse()
    .map(([, name, value]) => [name, value]),
);

function declarationsIn(body: string): Rule['declarations'] {
  return [...body.matchAll(/([\w-]+):\s*([^;]+);/g)].map(([, name = '', value = '']) => {
    const [, variable] = /^var\((.*)\)$/.exec(value) ?? [];
    return [name, (variable === undefined ? null : variables.get(variable)) ?? value];
  });
}

/** Of the page's style sheet the rules about shapes, in the order in which later ones win. */
const rules: readonly Rule[] = [...sheet.matchAll(/([^{}]+)\{([^{}]*)\}/g)]
  .flatMap(([, selectors = '', body = '']) =>
    selectors.split(',').flatMap((selector) => {
      const classes = selector.trim() === 'svg *' ? '' : selector.trim();
      if (!/^(\.[\w-]+)*$/.test(classes)) return [];
      return { classes: classes.split('.').slice(1), declarations: declarationsIn(body) };
    }),
  )
  .sort((a, b) => a.classes.length - b.classes.length);

/**
 * The look that the page's style sheet gives to classes, as attributes, where a unit is so many CSS pixels: many programs
 * that show drawings know nothing of style sheets.
 */
export function lookOf(look: string, scale: number): ReadonlyMap<string, string> {
  const classes = look.split(' ');
  const found = new Map<string, string>();
  for (const { classes: needed, declarations } of rules) {
    if (!needed.every((each) => classes.includes(each))) continue;
    for (const [name, value] of declarations) {
      if (attributes.includes(name)) found.set(name, value);
    }
  }
  if (found.get('stroke-dasharray') === 'none') found.delete('stroke-dasharray');
  for (const name of lengths) {
    const value = found
      .get(name)
      ?.replace(/([\d.]+)(px)?/g, (_, n) => `${short(Number(n) / scale)}`);
    if (value !== undefined) found.set(name, value);
  }
  return found;
}

/** Six digits are enough for a place in a drawing. */
export const short = (n: number): number => Number(n.toPrecision(6));
