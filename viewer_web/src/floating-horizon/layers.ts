/** The layers in the picture of a run of curves, each with a switch. */
export const curveLayers = ['lines', 'curve', 'horizons', 'columns', 'edges'] as const;
export type Layer = (typeof curveLayers)[number];

/** The choice of all layers. */
export const allLayers: ReadonlySet<Layer> = new Set(curveLayers);
export const linesAlone: ReadonlySet<Layer> = new Set<Layer>(['lines']);
