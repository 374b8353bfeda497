import { isLanguage } from './i18n/language.js';
import type { Language } from './i18n/language.js';
import type { Carried } from './live/live.js';
import type { Pixel } from './picture/pixel.js';
import { isLayer } from './picture/layers.js';
import type { Layer } from './picture/layers.js';
import { parseSetting, stepIn, writeSetting } from './setting.js';
import type { Setting } from './setting.js';
import { formatBookmarks, parseBookmarks } from './time/bookmarks.js';
import type { Bookmarks } from './time/bookmarks.js';

/** How the page is set up, whatever is open. */
export interface Setup {
  readonly language: Language;
  /** Whether it is shown to a hall. */
  readonly presenting: boolean;
  /** What the pixels show. */
  readonly layer: Layer;
  readonly setting: Setting;
}

/**
 * What the page's address holds behind `#`: how it is set up, embedded trace or a scene of one's own, what that is compared
 * with, step, chosen pixel, and bookmarks.
 */
export interface Address {
  readonly setup: Omit<Setup, 'language'> & { readonly language: Language | null };
  readonly trace: string | null;
  readonly live: Carried | null;
  /** What it is compared with: another embedded trace, or how else the scene is run. */
  readonly rival: string | null;
  readonly step: number;
  readonly pixel: Pixel | null;
  readonly bookmarks: Bookmarks;
}

function parsePixel(written: string | null): Pixel | null {
  const [, x, y] = /^(-?\d{1,9}),(-?\d{1,9})$/.exec(written ?? '') ?? [];
  return x === undefined || y === undefined ? null : [Number(x), Number(y)];
}

export function parseAddress(hash: string): Address {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const language = fields.get('lang');
  const scene = fields.get('scene');
  const layer = fields.get('layer');
  return {
    setup: {
      language: isLanguage(language) ? language : null,
      presenting: fields.get('view') === 'present',
      layer: isLayer(layer) ? layer : 'picture',
      setting: parseSetting(fields),
    },
    trace: fields.get('trace'),
    live: scene === null ? null : { scene, run: fields.get('run') ?? '' },
    rival: fields.get('with'),
    step: stepIn(fields.get('step')) ?? 0,
    pixel: parsePixel(fields.get('pixel')),
    bookmarks: parseBookmarks(fields.get('bookmarks') ?? ''),
  };
}

export function formatAddress(address: Address): string {
  const { setup, trace, live, rival, step, pixel, bookmarks } = address;
  const { language, presenting, layer, setting } = setup;
  const fields = new URLSearchParams();
  if (language !== null) fields.set('lang', language);
  if (trace !== null) fields.set('trace', trace);
  if (live !== null) {
    fields.set('run', live.run);
    fields.set('scene', live.scene);
  }
  if (trace !== null || live !== null) {
    writeSetting(setting, fields);
    if (rival !== null) fields.set('with', rival);
    if (presenting) fields.set('view', 'present');
    if (pixel !== null) fields.set('pixel', pixel.join());
    if (layer !== 'picture') fields.set('layer', layer);
    if (bookmarks.length > 0) fields.set('bookmarks', formatBookmarks(bookmarks));
    fields.set('step', String(step));
  }
  return `#${fields.toString()}`;
}
