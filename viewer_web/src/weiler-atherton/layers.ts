/** What the picture of a run with regions shows, each to be switched on and off. */
export const regionLayers = ['pixels', 'visible', 'list', 'parts', 'crossings'] as const;
export type RegionLayer = (typeof regionLayers)[number];

export const allLayers: ReadonlySet<RegionLayer> = new Set(regionLayers);
