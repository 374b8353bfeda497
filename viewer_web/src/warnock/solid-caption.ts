import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { SolidTexts } from '../language/solid-texts.js';
import { comparedPolygon, cornerDepths } from './solid-corners.js';
import { depthsAtPoint, pointInHand } from './solid-point.js';

/** A description of a window in the box. */
export function caption(view: View, texts: SolidTexts): readonly string[] {
  const { window = null, clip = null } = view.after.warnock ?? {};
  if (window === null) return [];
  return [
    texts.window(numbersOf(view).windowText(window)),
    ...(pointInHand(view) === null ? cornerWords(view, texts) : pointWords(view, texts)),
    ...(clip === null ? [] : [texts.clip]),
  ];
}

function cornerWords(view: View, texts: SolidTexts): readonly string[] {
  const depths = cornerDepths(view);
  const polygon = comparedPolygon(view);
  const { joined, short } = numbersOf(view);
  const own = depths.flatMap((each) =>
    each.own === null ? [] : [`${each.corner} ${short(each.own)}`],
  );
  const stored = depths.map((each) => `${each.corner} ${short(each.stored)}`);
  return [
    ...(polygon === null || own.length === 0 ? [] : [texts.plane(polygon, joined(own))]),
    ...(stored.length === 0 ? [] : [texts.corners(joined(stored))]),
  ];
}

function pointWords(view: View, texts: SolidTexts): readonly string[] {
  const at = pointInHand(view) ?? [];
  const { joined, point, short } = numbersOf(view);
  const depths = depthsAtPoint(view).map(({ polygon, z, told }) =>
    told ? `${polygon} ${short(z)}` : polygon,
  );
  return [texts.point(point(at), joined(depths) || texts.noPolygon)];
}
