import { describe, expect, it } from 'vitest';
import { formatAddress, parseAddress } from './address.js';
import { plain } from '../base/setting.js';

const usual = {
  language: 'en',
  view: null,
  presenting: false,
  layer: 'picture',
  setting: plain,
  reader: true,
  follows: false,
} as const;
const noLesson = { lesson: null, at: null, entry: null } as const;

describe('the address', () => {
  it('is parsed to the same values', () => {
    const address = {
      setup: {
        language: 'ru',
        view: 'workbench',
        presenting: true,
        layer: 'difference',
        setting: {
          embed: true,
          from: 3,
          to: 40,
          speed: 0.5,
          controls: 'none',
          play: true,
          ask: 'forced',
          keys: 'off.VX.XV',
        },
        reader: false,
        follows: true,
      },
      lesson: '01-near & far',
      at: 'split.2',
      trace: '01-near & far.warnock',
      entry: null,
      live: null,
      rival: 'zbuffer.printed.float.signs',
      step: 17,
      pixel: [3, -4],
      bookmarks: [
        { step: 3, note: 'здесь z = 1/2 & всё' },
        { step: 17, note: '' },
      ],
    } as const;
    expect(parseAddress(formatAddress(address))).toEqual(address);
  });

  it('stores a scene of the reader’s own', () => {
    const live = { run: 'zbuffer.corrected.bits:8.signs', scene: 'q1YqS8zJBwA-_' };
    const place = { step: 4, pixel: null, bookmarks: [{ step: 3, note: 'x' }] } as const;
    const address = {
      setup: usual,
      ...noLesson,
      trace: null,
      live,
      rival: null,
      ...place,
    } as const;
    expect(parseAddress(formatAddress(address))).toEqual(address);
  });

  it('opens an entry of the atlas beside its remedy, at the step where it shows or at a given step', () => {
    const entry = { ...noLesson, entry: 'near-parallel', trace: null, live: null };
    const place = { step: null, pixel: null, bookmarks: [] };
    const address = { setup: usual, ...entry, rival: 'remedy', ...place };
    expect(formatAddress(address)).toBe('#lang=en&atlas=near-parallel&with=remedy');
    expect(parseAddress('#lang=en&atlas=near-parallel&with=remedy')).toEqual(address);
    expect(parseAddress('#lang=en&atlas=near-parallel&step=7').step).toBe(7);
  });

  it('opens a place in the text of a lesson, with the step of that place', () => {
    const nothingElse = {
      trace: null,
      entry: null,
      live: null,
      rival: null,
      step: null,
      pixel: null,
    };
    const address = { setup: usual, lesson: '05-clip', at: '3', ...nothingElse, bookmarks: [] };
    expect(formatAddress(address)).toBe('#lang=en&lesson=05-clip&at=3');
    expect(parseAddress('#lang=en&lesson=05-clip&at=3')).toEqual(address);
  });

  it.each([
    ['view=lesson', 'lesson', false],
    ['view=workbench', 'workbench', false],
    ['view=workbench.present', 'workbench', true],
    ['view=present', null, true], // from before views existed
    ['reader=off', 'workbench', false],
    ['reader=off&view=lesson', 'lesson', false],
  ] as const)('says how the page is arranged: %s', (hash, view, presenting) => {
    const { setup } = parseAddress(`#lang=en&lesson=01-x&${hash}`);
    expect([setup.view, setup.presenting]).toEqual([view, presenting]);
  });

  it('drops step, pixel and bookmarks if nothing is open that a link can store', () => {
    const bookmarks = [{ step: 3, note: 'x' }];
    const setup = { ...usual, presenting: true, layer: 'exact' } as const;
    const place = { setup, step: 3, pixel: [1, 2], bookmarks } as const;
    expect(formatAddress({ ...noLesson, trace: null, live: null, rival: 'x', ...place })).toBe(
      '#lang=en',
    );
  });

  it.each([
    '#step=-1',
    '#step=1e400',
    '#step=1.5',
    '#lang=xx',
    '#%%%',
    '',
    '#step=abc',
    '#view=all',
    '#from=-1&to=x&speed=0&controls=all',
    '#layer=x',
    '#pixel=1',
    '#pixel=1,2,3',
    '#pixel=1.5,2',
    '#pixel=1e3,2',
    '#bookmarks=',
    '#bookmarks=%00*',
    '#bookmarks=bm90ZQ', // "note", without a step
    '#bookmarks=MTIg_w', // "12 ", then a byte that is not UTF-8
  ])('ignores nonsense: %s', (hash) => {
    expect(parseAddress(hash)).toEqual({
      setup: { ...usual, language: null },
      ...noLesson,
      trace: null,
      live: null,
      rival: null,
      step: null,
      pixel: null,
      bookmarks: [],
    });
  });
});
