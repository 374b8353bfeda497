import { svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { CurveLegendEntry, LegendEntry } from '../language/picture-texts.js';

const line = 'M1.5 10L18.5 4';

/** The icon of each entry, in a box of 20 by 14. */
const icons: Readonly<Record<CurveLegendEntry, readonly [look: string, d: string]>> = {
  visible: ['visible', line],
  inHand: ['in-hand', line],
  upper: ['upper', 'M1 7h18'],
  lower: ['lower', 'M1 7h18'],
  above: ['flag above', 'M6 10h8l-4 -7Z'],
  below: ['flag below', 'M6 4h8l-4 7Z'],
  hidden: ['flag hidden', 'M6.5 7a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0Z'],
  sideEdge: ['side-edge', line],
};

/** In the order of the legend. */
export const curveEntries = Object.keys(icons) as readonly CurveLegendEntry[];

export const isCurveEntry = (entry: LegendEntry): entry is CurveLegendEntry => entry in icons;

export function curveIcon(entry: CurveLegendEntry): SVGTemplateResult {
  const [look, d] = icons[entry];
  return svg`<path class=${look} d=${d} />`;
}
