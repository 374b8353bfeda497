import { DoubleSide, GreaterDepth } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { lookOf } from '../picture/looks.js';
import type { Line } from './drawing.js';
import { order, segmentsOf } from './geometry.js';

/** The dashes of hidden lines, as in technical drawing; CSS pixels. */
const hiddenDash = [3, 4] as const;
const hiddenOpacity = 0.45;

/** The looks without hidden lines: casings, and lines so numerous or faint that hidden ones would be confusing. */
const onlySeen = /casing|many|grid/;

interface Look {
  readonly color: string;
  readonly seen: LineMaterial;
  readonly hidden: LineMaterial | null;
}

/**
 * Lines on the stage, with the looks of the style sheet. Materials are cached, because each one compiles a program for the
 * graphics card.
 */
export class Ink {
  private readonly looks = new Map<string, Look>();

  constructor(private readonly host: Element) {}

  /** The objects that draw lines, one for each look. */
  lines(lines: readonly Line[]): readonly LineSegments2[] {
    const groups = new Map<string, Line[]>();
    for (const line of lines) {
      const group = groups.get(line.look);
      if (group) group.push(line);
      else groups.set(line.look, [line]);
    }
    return [...groups].flatMap(([look, group]) => this.group(look, group));
  }

  /** Sets the CSS pixels per unit, so that dashes keep their length on the page. */
  scale(scale: number): void {
    for (const material of this.materials) material.dashScale = scale;
  }

  dispose(): void {
    for (const material of this.materials) material.dispose();
  }

  private get materials(): readonly LineMaterial[] {
    return [...this.looks.values()].flatMap(({ seen, hidden }) => (hidden ? [seen, hidden] : seen));
  }

  private group(name: string, lines: readonly Line[]): readonly LineSegments2[] {
    const look = this.look(name);
    const geometry = segmentsOf(lines, look.color);
    const segments = (material: LineMaterial, at: number): LineSegments2 => {
      const object = new LineSegments2(geometry, material);
      object.renderOrder = at;
      return object.computeLineDistances();
    };
    const seen = segments(look.seen, name.includes('casing') ? order.casing : order.line);
    return look.hidden ? [segments(look.hidden, order.hidden), seen] : [seen];
  }

  private look(name: string): Look {
    const known = this.looks.get(name);
    if (known) return known;
    const values = lookOf(name, 1);
    const width = Number(values.get('stroke-width') ?? 1);
    const opacity = Number(values.get('stroke-opacity') ?? 1);
    const dash = values.get('stroke-dasharray')?.split(' ').map(Number) ?? null;
    const look: Look = {
      color: this.resolved(values.get('stroke') ?? '#10131c'),
      // A pointed line is visible even behind other things.
      seen: Object.assign(material(width, opacity, dash), { depthTest: !name.includes('pointed') }),
      hidden: onlySeen.test(name) ? null : hidden(Math.min(width, 1.5), opacity * hiddenOpacity),
    };
    this.looks.set(name, look);
    return look;
  }

  /** The value of a variable of the style sheet. */
  private resolved(color: string): string {
    const [, name] = /^var\((.*)\)$/.exec(color) ?? [];
    return name === undefined ? color : getComputedStyle(this.host).getPropertyValue(name).trim();
  }
}

function material(
  linewidth: number,
  opacity: number,
  dash: readonly number[] | null,
): LineMaterial {
  const made = new LineMaterial({
    vertexColors: true,
    // y is mirrored, so single-sided faces would be seen from behind.
    side: DoubleSide,
    forceSinglePass: true,
    linewidth,
    opacity,
    transparent: true,
    depthWrite: false,
  });
  if (dash !== null) {
    const [dashSize = 1, gapSize = dashSize] = dash;
    Object.assign(made, { dashed: true, dashSize, gapSize });
  }
  return made;
}

const hidden = (width: number, opacity: number): LineMaterial =>
  Object.assign(material(width, opacity, hiddenDash), { depthFunc: GreaterDepth });
