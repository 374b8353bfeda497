import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event, Method } from '../trace/events.js';
import type { N } from '../trace/values.js';
import { viewOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { caption, stepDrawing } from './scene.js';
import { Space } from './space.js';

/**
 * The last step of a run of these events on the 8 x 8 scene, whose squares have the depth 1/2: the box extends from 3/8 to
 * 5/8.
 */
async function after(method: Method, ...events: readonly Event[]): Promise<View> {
  const trace = await traceOf(textWith(headerOf(method), events));
  return viewOf(trace, events.length, { language: 'en', pixel: null, pointed: null });
}

const spaceOf = (view: View): Space => new Space(view.header.scene);
const words = (view: View): readonly string[] => caption(view, spaceOf(view), texts.en.solid);

const window: Event = { e: 'pop', at: 'W5', window: [4, 0, 4, 4] };
const push: Event = { e: 'push', at: 'W3', window: [4, 0, 4, 4], apl: [['A', false]] };
const corners: Event = { e: 'corners', at: 'PW1', z: '-inf' };
const depth = (x: number, y: number, z: N): Event => ({
  e: 'depth',
  at: 'PW5',
  polygon: 'A',
  point: [x, y],
  z,
});
const four = [depth(4, 0, 0.5), depth(4, 4, 0.4), depth(8, 0, 0.6), depth(8, 4, 0.5)];
const compare: Event = {
  e: 'compare',
  at: 'PW6',
  polygon: 'A',
  corner: 'rb',
  z: 0.6,
  against: '-inf',
  nearer: true,
};

describe('the current window', () => {
  it('is a column through the box', async () => {
    const view = await after('warnock', push, window);
    const drawing = stepDrawing(view, spaceOf(view));
    const frames = drawing.lines.filter(({ look, closed }) => look === 'window' && closed);
    // Relative to the middle, x from 4 to 8 is 0 to 4 and y from 0 to 4 is -4 to 0. The box is 4.8 deep.
    expect(
      frames.map(({ points }) => points.map(([x, y, z]) => [x, y, Number(z.toFixed(9))])),
    ).toEqual(
      [-2.4, 2.4].map((z) => [
        [0, -4, z],
        [4, -4, z],
        [4, 0, z],
        [0, 0, z],
      ]),
    );
    expect(drawing.faces).toHaveLength(4);
    expect(words(view)).toContain('Window (4, 0) 4 × 4: the column along z.');
  });
});

describe('the corners of the window', () => {
  it('have the depths stored so far, initially at the far end', async () => {
    const view = await after('warnock', push, window, corners);
    const { dots, labels } = stepDrawing(view, spaceOf(view));
    expect(labels.map(({ text }) => text)).toEqual(['lb −∞', 'lt −∞', 'rb −∞', 'rt −∞']);
    for (const { at } of dots) expect(at[2]).toBeCloseTo(-2.4);
  });

  it('have those of the current polygon’s plane as they are computed', async () => {
    const view = await after('warnock', push, window, corners, ...four.slice(0, 2));
    const { dots, labels, lines } = stepDrawing(view, spaceOf(view));
    expect(labels.map(({ text }) => text)).toEqual([
      '−∞',
      'lb 0.5',
      '−∞',
      'lt 0.4',
      'rb −∞',
      'rt −∞',
    ]);
    // 0.4 is 0.1 behind the middle, at 19.2 pixels per unit.
    expect(dots[3]?.at[2]).toBeCloseTo(-1.92);
    // The plane over the window is dashed, in the colour of A.
    expect(lines.find(({ look }) => look === 'clip')?.color).toBe('#112233');
    expect(words(view)).toContain('On the plane of A: lb 0.5, lt 0.4.');
    const russian = caption({ ...view, language: 'ru' }, spaceOf(view), texts.ru.solid);
    expect(russian).toContain('На плоскости A: lb 0,5; lt 0,4.');
  });

  it('show which is nearer when that is decided', async () => {
    const view = await after('warnock', push, window, corners, ...four, compare);
    const { dots, labels } = stepDrawing(view, spaceOf(view));
    expect(dots.map(({ role }) => role)).toEqual(
      // stored and own at lb, lt, rb, rt
      ['window', 'yes', 'window', 'yes', 'no', 'yes', 'window', 'yes'],
    );
    expect(labels.filter(({ strong }) => strong).map(({ text }) => text)).toEqual(['rb 0.6']);
  });

  it('show the replaced depths at the step that copies the nearer ones', async () => {
    const nearer: Event = { e: 'nearer', at: 'PW6', polygon: 'A', corners: ['rb'], k: 1 };
    const view = await after('warnock', push, window, corners, ...four, nearer);
    expect(words(view)).toContain('Nearest so far at its corners: lb −∞, lt −∞, rb −∞, rt −∞.');
    const { dots } = stepDrawing(view, spaceOf(view));
    expect(dots.map(({ role }) => role)).toEqual([
      'yes',
      'no',
      'yes',
      'no',
      'no',
      'yes',
      'yes',
      'no',
    ]);
  });
});

describe('PointColor', () => {
  it('has a line through the middle of the window, and its intersections with polygons', async () => {
    const call: Event = { e: 'call', at: 'W9', of: 'PointColor' };
    const depth: Event = { e: 'depth', at: 'PC3', polygon: 'A', point: [6, 2], z: 0.5 };
    const view = await after('warnock', push, window, call, depth);
    const { dots, labels } = stepDrawing(view, spaceOf(view));
    // (6, 2) is 2 to the right of the middle and 2 above it; 1/2 is the middle depth.
    expect(dots).toEqual([{ role: 'point', at: [2, -2, 0] }]);
    expect(labels.map(({ text }) => text)).toEqual(['A 0.5']);
    expect(words(view)).toContain('On the line through (6, 2): A 0.5.');
  });
});

describe('the Z-buffer', () => {
  const begun: readonly Event[] = [
    { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' },
    { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
    { e: 'scanline', at: 'Z6', y: 2.5, row: 2 },
    { e: 'ael_add', at: 'Z8', edge: 3, x: 0, z: 0.5, until: 7, dx: 0, dz: 0 },
    { e: 'ael_add', at: 'Z8', edge: 1, x: 8, z: 0.6, until: 7, dx: 0, dz: 0 },
  ];
  const show: Event = { e: 'call', at: 'Z14', of: 'ShowLine' };

  it('has the scanline as a plane, and its active edges', async () => {
    const view = await after('zbuffer', ...begun);
    const { faces, dots, lines } = stepDrawing(view, spaceOf(view));
    // The middle of row 2 is 1.5 above the middle.
    expect(faces).toHaveLength(1);
    expect(faces[0]?.points.every(([, y]) => y === -1.5)).toBe(true);
    expect(dots.map(({ at: [x, y] }) => [x, y])).toEqual([
      [-4, -1.5],
      [4, -1.5],
    ]);
    expect(lines.filter(({ look }) => look === 'edge')).toHaveLength(2);
    expect(words(view)).toContain('Row 2: the plane along z. Active edges: 3, 1.');
  });

  it('has the span in 3D while ShowLine runs', async () => {
    const view = await after('zbuffer', ...begun, show);
    const [span] = stepDrawing(view, spaceOf(view)).lines.filter(({ look }) => look === 'side');
    const ends = span?.points.map((at) => at.map((each) => Number(each.toFixed(9))));
    // 0.6 is 0.1 in front of the middle.
    expect(ends).toEqual([
      [-4, -1.5, 0],
      [4, -1.5, 1.92],
    ]);
    expect(words(view)).toContain('Line (x, z): from (0, 0.5) to (8, 0.6).');
  });

  it('has the current pixel as a column, with the stored depth and the new one', async () => {
    const pixel: Event = { e: 'pixel', at: 'L6', x: 0, y: 2, z: 0.5, stored: '-inf', shown: true };
    const view = await after('zbuffer', ...begun, show, pixel);
    const { dots, labels } = stepDrawing(view, spaceOf(view));
    expect(dots.slice(-2).map(({ role, at: [x, y] }) => [role, x, y])).toEqual([
      ['no', -3.5, -1.5],
      ['yes', -3.5, -1.5],
    ]);
    expect(labels.slice(-2).map(({ text }) => text)).toEqual(['−∞', '0.5']);
    expect(words(view)).toContain('Pixel (0, 2): depth 0.5, stored −∞.');
  });
});

describe('a part without a place', () => {
  it('is left out', async () => {
    const view = await after('warnock', push, window, corners, depth(4, 0, 'nan'));
    expect(stepDrawing(view, spaceOf(view)).dots).toHaveLength(4);
  });
});
