import { KeyMap } from './key-map.js';

export const controlSets = ['full', 'small', 'none'] as const;

/**
 * What is shown to steer by: everything; the buttons and the slider, beside picture and listing alone; or nothing, not even
 * keys.
 */
export type Controls = (typeof controlSets)[number];

export const ways = ['free', 'forced'] as const;

/** How questions are asked: when the reader wants one, or wherever there is one, which must be answered to go on. */
export type Way = (typeof ways)[number];

/** How whoever embeds the page sets it up. */
export interface Setting {
  /** Whether there is only the player, as in a frame of another page. */
  readonly embed: boolean;
  /** The first and the last step that can be reached; null: the last one of the trace. */
  readonly from: number;
  readonly to: number | null;
  /** Steps a second; null: as usual. */
  readonly speed: number | null;
  readonly controls: Controls;
  /** Whether it plays as soon as it is there. */
  readonly play: boolean;
  /** Whether there are questions from the beginning, and how they are asked. */
  readonly ask: Way | null;
  /** Which keys of one letter do what, see `KeyMap`. */
  readonly keys: string;
}

/** The page by itself. */
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

/** Only what means keys. */
function keysIn(written: string): string {
  const map = new KeyMap();
  map.word = written;
  return map.word;
}

/** The number of a step, if that is what is written. */
export function stepIn(written: string | null): number | null {
  const step = Number(written ?? NaN);
  return Number.isSafeInteger(step) && step >= 0 ? step : null;
}

export function isControls(value: unknown): value is Controls {
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

/** Writes what is not as on the page by itself. */
export function writeSetting(setting: Setting, fields: URLSearchParams): void {
  for (const [name, value] of Object.entries(setting)) {
    if (value !== plain[name as keyof Setting])
      fields.set(name, value === true ? '' : String(value));
  }
}
