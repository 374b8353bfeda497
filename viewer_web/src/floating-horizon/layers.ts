/** What the picture of a run of curves shows, each to be switched on and off. */
export const curveLayers = ['lines', 'curve', 'horizons', 'columns', 'edges'] as const;
export type Layer = (typeof curveLayers)[number];

/** All of it, or the lines alone. */
export const allLayers: ReadonlySet<Layer> = new Set(curveLayers);
export const linesAlone: ReadonlySet<Layer> = new Set<Layer>(['lines']);
