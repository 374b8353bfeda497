import { kinds } from './format.js';
import type { Chart, Kind, Scene } from './format.js';

/** What may be looked at: one scene, or all of a kind together. */
export interface View {
  /** Its name in the page's address. */
  readonly id: string;
  readonly kind: Kind;
  /** The scene's; null for all of the kind. */
  readonly name: string | null;
  readonly scenes: readonly Scene[];
}

/** Scenes may have one name: the second is its `(2)`. */
function named(scenes: readonly Scene[]): readonly (readonly [string, Scene])[] {
  const seen = new Map<string, number>();
  return scenes.map((scene) => {
    const times = (seen.get(scene.name) ?? 0) + 1;
    seen.set(scene.name, times);
    return [times === 1 ? scene.name : `${scene.name} (${times})`, scene];
  });
}

export function viewsOf(chart: Chart): readonly View[] {
  return kinds.flatMap((kind): readonly View[] => {
    const scenes = chart.scenes.filter((scene) => scene.kind === kind);
    const single = named(scenes).map(([name, scene]) => ({
      id: `${kind}/${name}`,
      kind,
      name,
      scenes: [scene],
    }));
    return scenes.length < 2 ? single : [{ id: kind, kind, name: null, scenes }, ...single];
  });
}
