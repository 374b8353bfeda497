import type { Quick } from '../language/compare-texts.js';
import { editionsOf, runnable, runs } from '../run/options.js';
import type { Options } from '../run/options.js';
import { drawsCurves } from '../trace/events.js';
import type { Method } from '../trace/events.js';

/** The other methods for the scene; curves have a single method. */
function otherMethods(method: Method): readonly Method[] {
  if (drawsCurves(method)) return [];
  return [method === 'warnock' ? 'zbuffer' : 'warnock'];
}

/** The settings with which a run is most often compared. */
export function quickRuns(options: Options): readonly (readonly [Quick, Options])[] {
  const { method, edition, kernel } = options;
  const variants: readonly Method[] = method === 'warnock' ? ['warnock-full'] : [];
  const otherEdition = edition === 'corrected' ? 'printed' : 'corrected';
  const editions = editionsOf(method).includes(otherEdition) ? ([otherEdition] as const) : [];
  const kernels = (['exact', 'float'] as const).filter(
    (each) => each !== kernel && runs({ ...options, kernel: each }),
  );
  return [
    ...otherMethods(method).map(
      (other) => ['method', runnable({ ...options, method: other })] as const,
    ),
    ...variants.map((each) => ['variant', runnable({ ...options, method: each })] as const),
    ...editions.map((each) => [each, runnable({ ...options, edition: each })] as const),
    ...kernels.map((each) => [each, { ...options, kernel: each }] as const),
  ];
}
