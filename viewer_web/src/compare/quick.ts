import type { Quick } from '../i18n/compare-texts.js';
import { runnable } from '../live/options.js';
import type { Method } from '../trace/events.js';
import type { Options } from '../live/options.js';

/** The ways to run a scene that a run is most often held against. */
export function quickRuns(options: Options): readonly (readonly [Quick, Options])[] {
  const { method, edition, kernel } = options;
  const others: Readonly<Partial<Record<Method, Method>>> = {
    warnock: 'zbuffer',
    zbuffer: 'warnock',
  };
  const otherMethod = others[method];
  const otherEdition = edition === 'printed' ? 'corrected' : 'printed';
  const kernels = (['exact', 'float'] as const).filter((each) => each !== kernel);
  return [
    ...(otherMethod === undefined
      ? []
      : [['method', runnable({ ...options, method: otherMethod })] as const]),
    [otherEdition, runnable({ ...options, edition: otherEdition })],
    ...kernels.map((each) => [each, { ...options, kernel: each }] as const),
  ];
}
