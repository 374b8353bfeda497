import { describe, expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import { Course } from '../time/course.js';
import { wholeOf } from '../time/range.js';
import type { Event } from '../trace/events.js';
import type { Look } from './look.js';
import { StripPainter } from './paint.js';

const colorOf = (i: number): string => `#${i.toString(16).padStart(6, '0')}`;

/** The colours of a strip of this width over a run of `count` polygons, and the number of stripe patterns. */
async function painted(count: number, width: number) {
  const polygons = Array.from({ length: count }, (_, i) => ({
    id: `P${i}`,
    color: colorOf(i),
    vertices: [
      [0, 0, 0],
      [8, 0, 0],
      [0, 8, 0],
    ],
  }));
  const header = headerOf('zbuffer', 'windows') as { scene: object };
  const events = polygons.map(({ id, color }): Event => ({
    e: 'polygon',
    at: 'Z2',
    polygon: id,
    color,
  }));
  const trace = await traceOf(
    textWith({ ...header, scene: { ...header.scene, polygons } }, events),
  );
  const course = new Course(trace);
  course.read();
  const fills = new Set<unknown>();
  const context = {
    canvas: { width, height: 52 },
    fillStyle: '' as unknown,
    clearRect: () => undefined,
    fillRect: () => fills.add(context.fillStyle),
    fillText: () => undefined,
    measureText: () => ({ width: 8 }),
  };
  let stripes = 0;
  const look = {
    ratio: 1,
    ground: 'ground',
    ink: 'ink',
    ofPolygon: ({ color }: { color: string }) => {
      stripes++;
      return `stripes ${color}`;
    },
  } as unknown as Look;
  const canvas = context as unknown as CanvasRenderingContext2D;
  new StripPainter(canvas, course, look, wholeOf(course.length)).paint();
  return { fills, stripes };
}

describe('the polygons of a strip', () => {
  it('have a texture each where there is room for it', async () => {
    const { fills, stripes } = await painted(10, 60);
    expect(stripes).toBe(10);
    for (let i = 0; i < 10; i++) expect(fills).toContain(`stripes ${colorOf(i)}`);
  });

  it('have plain colours where thousands have less room than a texture', async () => {
    const { fills, stripes } = await painted(5000, 1000);
    expect(stripes).toBe(0);
    expect(fills).toContain(colorOf(0));
    expect(fills).toContain(colorOf(4999));
  });
});
