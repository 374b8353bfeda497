import type { View } from '../algorithm/view.js';
import { element, escaped } from '../base/markup.js';
import { inOneLine } from '../language/stated.js';
import { nameIn } from '../language/scene-name.js';
import { sceneDrawing, stepDrawing } from './drawing.js';
import { Frame } from './frame.js';
import { lookOf, short } from './looks.js';
import { patchesOf } from './patches.js';
import type { Shape } from './shapes.js';
import { labelSize, labelsOf, swatchOf } from './still.js';
import type { Label } from './still.js';

/** The longer side, in CSS pixels. */
const side = 720;

/** An SVG path of a shape, at a scale of CSS pixels per unit. */
export function pathOf({ look, d, color, fill }: Shape, scale: number): string {
  const attributes = new Map([...lookOf(look, scale), ['d', d]]);
  if (color !== undefined) attributes.set('stroke', color);
  if (fill !== undefined) attributes.set('fill', fill);
  return element('path', attributes);
}

/** The text is written twice, first as a light rim, because few programs can draw rim and text at once. */
function label(written: Label, { whole, scale }: Frame): string {
  const { text, color, at } = written;
  const [x, y] = at;
  const swatch = swatchOf(written, labelSize);
  const square = {
    x: short((x - whole[0]) * scale + (swatch?.x ?? 0)),
    y: short((y - whole[1]) * scale - (swatch?.size ?? 0) / 2),
    width: short(swatch?.size ?? 0),
    height: short(swatch?.size ?? 0),
    fill: color ?? '',
    stroke: '#ffffff',
  };
  const attributes = {
    x: short((x - whole[0]) * scale + (swatch?.shift ?? 0)),
    y: short((y - whole[1]) * scale + labelSize * 0.36),
    'text-anchor': 'middle',
    'font-family': 'sans-serif',
    'font-weight': 'bold',
    'font-size': labelSize,
  };
  const look = lookOf('label', 1);
  const fill = look.get('fill') ?? '';
  const rim = [...Object.entries(attributes), ...look];
  return (
    (swatch === null ? '' : element('rect', Object.entries(square))) +
    element('text', rim, escaped(text)) +
    element('text', Object.entries({ ...attributes, fill }), escaped(text))
  );
}

/** The frame of a view's figure. */
export const figureFrame = ({ header }: View): Frame =>
  new Frame(header.scene.area, { width: side, height: side });

/** Additional shapes, under and over the polygons' outlines. */
interface Layers {
  readonly under: readonly Shape[];
  readonly over: readonly Shape[];
}

/**
 * The picture at a step, with its marks and names, as a separate SVG document that looks the same wherever it is opened:
 * vectors only, looks as attributes, on white. The same view gives the same bytes.
 */
export function figureOf(view: View, { under, over }: Layers = { under: [], over: [] }): string {
  const { scene } = view.header;
  const frame = figureFrame(view);
  const { scale } = frame;

  const patches = patchesOf(view.screen.picture, scene.area);
  const pixels = patches.map(({ color, d }) => element('path', Object.entries({ fill: color, d })));
  // Neighbouring pixels must meet without a seam.
  const sharp = element('g', [['shape-rendering', 'crispEdges']], `\n${pixels.join('')}`);
  const still = sceneDrawing(scene, frame, under);
  const step = stepDrawing({ ...view, pointed: null, asked: [] }, frame, over);
  const shapes = [...still, ...step.shapes].map((shape) => pathOf(shape, scale));
  const names = [...labelsOf(scene, frame, view.screen.picture), ...step.labels].map((each) =>
    label(each, frame),
  );
  return figureDocument(view, frame, `${sharp}${shapes.join('')}`, names.join(''));
}

/** The document with a drawing in the plane, and labels in CSS pixels. */
export function figureDocument(view: View, frame: Frame, drawing: string, names = ''): string {
  const { header, step, texts } = view;
  const { scene } = header;
  const { whole, scale } = frame;
  const width = Math.round(whole[2] * scale);
  const height = Math.round(whole[3] * scale);
  const place = `scale(${scale}) translate(${-whole[0]} ${-whole[1]})`;

  const title = [
    nameIn(view.language, scene.name),
    texts.methods[header.method],
    `${texts.step} ${step}`,
  ];
  const content = [
    element('title', [], escaped(title.filter(Boolean).join(' · '))),
    element('desc', [], escaped(inOneLine(view.sentence))),
    element('rect', Object.entries({ width, height, fill: '#ffffff' })),
    element('g', [['transform', place]], `\n${drawing}`),
    names,
  ];
  const document = Object.entries({
    xmlns: 'http://www.w3.org/2000/svg',
    width,
    height,
    viewBox: `0 0 ${width} ${height}`,
    'xml:lang': view.language,
  });
  return `<?xml version="1.0" encoding="UTF-8"?>\n${element('svg', document, `\n${content.join('')}`)}`;
}
