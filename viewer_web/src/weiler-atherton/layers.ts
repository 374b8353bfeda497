/** The layers in the picture of a run with regions, each with a switch. */
export const regionLayers = ['pixels', 'visible', 'list', 'parts', 'crossings'] as const;
export type RegionLayer = (typeof regionLayers)[number];

export const allLayers: ReadonlySet<RegionLayer> = new Set(regionLayers);
