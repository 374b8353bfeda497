import { tokens } from '../elements/theme.js';
import { curvesStyle } from './curves.style.js';
import { marksStyle } from './marks.style.js';
import { pictureStyle } from './picture.style.js';
import { regionsStyle } from './regions.style.js';

/** Declarations for elements with all of some classes. */
interface Rule {
  readonly classes: readonly string[];
  readonly declarations: readonly (readonly [name: string, value: string])[];
}

/** The properties of a look that become attributes; the lengths are in CSS pixels. */
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

/** The page's own variables have their values of the light theme: the marks are alike in both. */
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

/** The rules about shapes in the page's style sheet, in the order of their priority, the last one highest. */
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
 * The look that the page's style sheet gives to classes, as attributes, at a scale of CSS pixels per unit. Many programs
 * that display drawings do not support style sheets.
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

/** Six digits suffice for a coordinate in a drawing. */
export const short = (n: number): number => Number(n.toPrecision(6));
