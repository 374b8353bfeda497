import { isLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import type { Carried } from '../editor/live.js';
import type { Pixel } from '../picture/pixel.js';
import { isLayer } from '../picture/layers.js';
import type { Layer } from '../picture/layers.js';
import { isPageView, parseSetting, stepIn, writeSetting } from '../base/setting.js';
import type { PageView, Setting } from '../base/setting.js';
import { formatBookmarks, parseBookmarks } from '../time/bookmarks.js';
import type { Bookmarks } from '../time/bookmarks.js';

/** The setup of the page, whatever is open. */
export interface Setup {
  readonly language: Language;
  /** The view; null for the one that suits what is open. */
  readonly view: PageView | null;
  /** Whether the presentation is on. */
  readonly presenting: boolean;
  /** The layer that the pixels show. */
  readonly layer: Layer;
  readonly setting: Setting;
  /** Whether the text of the lesson is shown, if it has one, and whether the run follows it. */
  readonly reader: boolean;
  readonly follows: boolean;
}

/**
 * What the page's address stores behind `#`: the setup, the lesson and the place in its text, the embedded trace, atlas
 * entry or edited scene, the run compared with it, the step, the chosen pixel, and the bookmarks.
 */
export interface Address {
  readonly setup: Omit<Setup, 'language'> & { readonly language: Language | null };
  /** The lesson whose text is open, and the name of a place in it. */
  readonly lesson: string | null;
  readonly at: string | null;
  readonly trace: string | null;
  /** An entry of the atlas of failures: its scene, with the failing settings. */
  readonly entry: string | null;
  readonly live: Carried | null;
  /** The run compared with it: another embedded trace, other settings for the scene, or the remedy of the entry. */
  readonly rival: string | null;
  /** The step in the smallest scene that shows how the other run is broken, if that scene is open. */
  readonly witness?: number | null;
  /** Null means the step of the place in the text, the one where the failure shows, or the beginning. */
  readonly step: number | null;
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
  const view = (fields.get('view') ?? '').split('.');
  const reader = fields.get('reader') !== 'off';
  return {
    setup: {
      language: isLanguage(language) ? language : null,
      // An old link, from before views existed, showed the whole workbench if it hid the text.
      view: view.find(isPageView) ?? (reader ? null : 'workbench'),
      presenting: view.includes('present'),
      layer: isLayer(layer) ? layer : 'picture',
      setting: parseSetting(fields),
      reader,
      follows: fields.get('follow') === 'on',
    },
    lesson: fields.get('lesson'),
    at: fields.get('at'),
    trace: fields.get('trace'),
    entry: fields.get('atlas'),
    live: scene === null ? null : { scene, run: fields.get('run') ?? '' },
    rival: fields.get('with'),
    ...(fields.has('witness') ? { witness: stepIn(fields.get('witness')) } : {}),
    step: stepIn(fields.get('step')),
    pixel: parsePixel(fields.get('pixel')),
    bookmarks: parseBookmarks(fields.get('bookmarks') ?? ''),
  };
}

/** Whether the address leaves open what to show. */
export const namesNothing = ({
  lesson,
  trace,
  entry,
  live,
}: Pick<Address, 'lesson' | 'trace' | 'entry' | 'live'>): boolean =>
  lesson === null && trace === null && entry === null && live === null;

export function formatAddress(address: Address): string {
  const { setup, lesson, at, trace, entry, live, rival, witness = null } = address;
  const { step, pixel, bookmarks } = address;
  const { language, view, presenting, layer, setting, reader, follows } = setup;
  const shown = [view ?? [], presenting ? 'present' : []].flat();
  const fields = new URLSearchParams();
  if (language !== null) fields.set('lang', language);
  if (setup.setting.keys !== '') fields.set('keys', setup.setting.keys);
  if (lesson !== null) fields.set('lesson', lesson);
  if (lesson !== null && at !== null) fields.set('at', at);
  if (trace !== null) fields.set('trace', trace);
  if (entry !== null) fields.set('atlas', entry);
  if (live !== null) {
    fields.set('run', live.run);
    fields.set('scene', live.scene);
  }
  if (!namesNothing(address)) {
    if (!reader) fields.set('reader', 'off');
    if (follows) fields.set('follow', 'on');
    writeSetting(setting, fields);
    if (rival !== null) fields.set('with', rival);
    if (rival !== null && witness !== null) fields.set('witness', String(witness));
    if (shown.length > 0) fields.set('view', shown.join('.'));
    if (pixel !== null) fields.set('pixel', pixel.join());
    if (layer !== 'picture') fields.set('layer', layer);
    if (bookmarks.length > 0) fields.set('bookmarks', formatBookmarks(bookmarks));
    if (step !== null) fields.set('step', String(step));
  }
  return `#${fields.toString()}`;
}
