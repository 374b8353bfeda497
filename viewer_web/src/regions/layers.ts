/** What the picture of a run with regions shows, each to be switched on and off. */
export const regionLayers = ['pixels', 'visible', 'list', 'parts', 'crossings'] as const;
export type RegionLayer = (typeof regionLayers)[number];

export const allLayers: ReadonlySet<RegionLayer> = new Set(regionLayers);

export function switched(
  shown: ReadonlySet<RegionLayer>,
  layer: RegionLayer,
): ReadonlySet<RegionLayer> {
  return new Set(regionLayers.filter((each) => shown.has(each) !== (each === layer)));
}
