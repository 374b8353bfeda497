import { KeyMap } from './key-map.js';

/** The layouts of the page: around a text and its run, or around a run with everything known about it. */
const pageViews = ['lesson', 'workbench'] as const;
export type PageView = (typeof pageViews)[number];

export const isPageView = (name: string): name is PageView =>
  (pageViews as readonly string[]).includes(name);

const controlSets = ['full', 'small', 'none'] as const;

/** The controls to show: all of them; the buttons and the slider, with picture and listing only; or none, not even keys. */
type Controls = (typeof controlSets)[number];

const ways = ['free', 'forced'] as const;

/** When questions are asked: on request, or at every step that has one, where an answer is required to go on. */
export type Way = (typeof ways)[number];

/** The configuration of an embedded page. */
export interface Setting {
  /** Whether there is only the player, as in a frame of another page. */
  readonly embed: boolean;
  /** The first and the last reachable step; null is the last step of the trace. */
  readonly from: number;
  readonly to: number | null;
  /** Steps per second; null for the usual speed. */
  readonly speed: number | null;
  readonly controls: Controls;
  /** Whether it starts to play immediately. */
  readonly play: boolean;
  /** Whether questions are on from the beginning, and how they are asked. */
  readonly ask: Way | null;
  /** The assignment of single-letter keys, see `KeyMap`. */
  readonly keys: string;
}

/** The page on its own. */
export const plain: Setting = {
  embed: false,
  from: 0,
  to: null,
  speed: null,
  controls: 'full',
  play: false,
  ask: null,
  keys: '',
};

/** Keeps only valid key assignments. */
function keysIn(written: string): string {
  const map = new KeyMap();
  map.word = written;
  return map.word;
}

/** The number of a step; null if the text is not one. */
export function stepIn(written: string | null): number | null {
  const step = Number(written ?? NaN);
  return Number.isSafeInteger(step) && step >= 0 ? step : null;
}

function isControls(value: unknown): value is Controls {
  return controlSets.includes(value as Controls);
}

export function isWay(value: unknown): value is Way {
  return ways.includes(value as Way);
}

export function isSpeed(value: unknown): value is number {
  return typeof value === 'number' && value >= 0.1 && value <= 1000;
}

export function parseSetting(fields: URLSearchParams): Setting {
  const speed = Number(fields.get('speed') ?? NaN);
  const controls = fields.get('controls');
  const ask = fields.get('ask');
  return {
    embed: fields.has('embed'),
    from: stepIn(fields.get('from')) ?? plain.from,
    to: stepIn(fields.get('to')),
    speed: isSpeed(speed) ? speed : null,
    controls: isControls(controls) ? controls : plain.controls,
    play: fields.has('play'),
    ask: isWay(ask) ? ask : plain.ask,
    keys: keysIn(fields.get('keys') ?? plain.keys),
  };
}

/** Writes the settings that differ from those of the page on its own. */
export function writeSetting(setting: Setting, fields: URLSearchParams): void {
  for (const [name, value] of Object.entries(setting)) {
    if (value !== plain[name as keyof Setting])
      fields.set(name, value === true ? '' : String(value));
  }
}
