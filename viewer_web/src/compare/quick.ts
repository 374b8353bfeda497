import type { Quick } from '../i18n/compare-texts.js';
import { runnable } from '../live/options.js';
import type { Options } from '../live/options.js';

/** The ways to run a scene that a run is most often held against. */
export function quickRuns(options: Options): readonly (readonly [Quick, Options])[] {
  const { method, edition, kernel } = options;
  const otherMethod = method === 'warnock' ? 'zbuffer' : 'warnock';
  const otherEdition = edition === 'printed' ? 'corrected' : 'printed';
  const kernels = (['exact', 'float'] as const).filter((each) => each !== kernel);
  return [
    ['method', runnable({ ...options, method: otherMethod })],
    [otherEdition, runnable({ ...options, edition: otherEdition })],
    ...kernels.map((each) => [each, { ...options, kernel: each }] as const),
  ];
}
