import { describe, expect, it } from 'vitest';
import { headerOf, parseHeader } from '../testing/traces.js';
import { Zoom } from './zoom.js';

const header = parseHeader(headerOf('warnock'));
const other = parseHeader(headerOf('zbuffer'));
const length = 1000;

function zoomAt(step: number): Zoom {
  const zoom = new Zoom();
  zoom.follow(header, length, step);
  zoom.showWhole();
  return zoom;
}

describe('the zoom of a strip', () => {
  it('is none at first, and for a run that grows', () => {
    const zoom = zoomAt(0);
    expect([zoom.range, zoom.isWhole]).toEqual([{ from: 0, to: 1000 }, true]);
    zoom.follow(header, 1500, 0);
    expect([zoom.range, zoom.isWhole]).toEqual([{ from: 0, to: 1500 }, true]);
  });

  it('is around the step, or around the middle where the step is out of sight', () => {
    const zoom = zoomAt(250);
    zoom.zoom(2);
    expect(zoom.range).toEqual({ from: 125, to: 625 }); // 250 is at a quarter of both
    zoom.move(1);
    expect(zoom.range).toEqual({ from: 500, to: 1000 });
    zoom.zoom(5);
    expect(zoom.range).toEqual({ from: 700, to: 800 });
  });

  it('follows a step that leaves the range, but stays where it was moved to', () => {
    const zoom = zoomAt(500);
    zoom.show({ from: 450, to: 550 });
    zoom.follow(header, length, 551);
    expect(zoom.range).toEqual({ from: 541, to: 641 });
    zoom.show({ from: 0, to: 100 });
    zoom.follow(header, length, 551);
    expect(zoom.range).toEqual({ from: 0, to: 100 });
    zoom.follow(header, length, 550);
    expect(zoom.range).toEqual({ from: 540, to: 640 });
  });

  it('is remembered by run', () => {
    const zoom = zoomAt(0);
    zoom.show({ from: 0, to: 100 });
    zoom.follow(other, length, 0);
    expect(zoom.isWhole).toBe(true);
    zoom.follow(header, length, 500);
    expect(zoom.range).toEqual({ from: 0, to: 100 });
    zoom.showWhole();
    zoom.follow(other, length, 0);
    zoom.follow(header, length, 0);
    expect(zoom.isWhole).toBe(true);
  });

  it('stays in a run that has become shorter', () => {
    const zoom = zoomAt(0);
    zoom.show({ from: 900, to: 1000 });
    zoom.follow(header, 500, 0);
    expect(zoom.range).toEqual({ from: 400, to: 500 });
  });
});
