/** Where the line of an edge passes the centre of a pixel, in the pixel's row or column; PROOF.md explains it. */
export interface Passing {
  readonly edge: number;
  readonly passes: 'left' | 'right' | 'above' | 'below' | 'through';
  readonly away: string;
}

/** How a polygon stands at a pixel, as `vidno-why/1` has it. Depths and distances are fractions. */
export interface AtPixel {
  readonly polygon: string;
  readonly standing: 'shows' | 'behind' | 'beside' | 'edge_on';
  readonly depth?: string;
  readonly gap?: string;
  readonly next?: string;
  readonly edges?: readonly Passing[];
}

/** Why a polygon shows at a pixel or not, also in the words of `vidno why`. */
export interface Reason {
  readonly said: string;
  /** Null: no polygon shows. */
  readonly at: AtPixel | null;
}

/** The polygons that hold the centre of a pixel, by their places in the scene, and the one that shows. */
export interface Holding {
  readonly owner: number | null;
  readonly holding: readonly number[];
}

/** The places of a scene's polygons at a pixel: the owner, others that hold its centre, and those that do not. */
export interface Standings {
  readonly owner: number | null;
  readonly holding: readonly number[];
  readonly others: readonly number[];
}

export function standingsOf({ owner, holding }: Holding, polygons: number): Standings {
  const holds = new Set(holding);
  const places = Array.from({ length: polygons }, (_, place) => place);
  return {
    owner,
    holding: holding.filter((place) => place !== owner),
    others: places.filter((place) => !holds.has(place)),
  };
}
