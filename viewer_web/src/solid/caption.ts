import type { SolidTexts } from '../language/solid-texts.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { comparedPolygon, cornerDepths } from '../warnock/solid-corners.js';
import { depthsAtPoint, pointInHand } from '../warnock/solid-point.js';
import type { Space } from './space.js';
import { spansOf } from '../zbuffer/solid.js';

/** What the box shows, in words: first what never changes in a scene, then what the step shows. */
export function caption(view: View, space: Space, texts: SolidTexts): readonly string[] {
  const [far, near] = space.depths.map(numbersOf(view).short);
  const depths = texts.depths(far ?? '', near ?? '');
  return [depths, ...warnockWords(view, texts), ...zbufferWords(view, texts)];
}

function warnockWords(view: View, texts: SolidTexts): readonly string[] {
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

function zbufferWords(view: View, texts: SolidTexts): readonly string[] {
  const { row = null, ael = [] } = view.after.zbuffer ?? {};
  if (row === null) return [];
  const edges = ael.map(({ edge }) => edge).join(', ') || '—';
  const { event } = view;
  return [
    texts.scanline(String(row), edges),
    ...spansOf(view).map(([[x0, , z0], [x1, , z1]]) =>
      texts.span(numbersOf(view).point([x0, z0]), numbersOf(view).point([x1, z1])),
    ),
    ...(event?.e === 'pixel'
      ? [
          texts.pixel(
            numbersOf(view).point([event.x, event.y]),
            numbersOf(view).short(event.z),
            numbersOf(view).short(event.stored),
          ),
        ]
      : []),
  ];
}
