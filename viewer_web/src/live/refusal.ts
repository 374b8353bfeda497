import type { Sketch } from './sketch.js';

export interface SceneRefusal {
  /** The polygon that is at fault, if it is one. */
  readonly polygon: string | null;
  readonly reason: string;
}

/** What the library says of a scene that it does not take: "scene: /polygons/0/vertices: not convex". */
export function refusalOf(message: string, { polygons }: Sketch): SceneRefusal {
  const line = message.trim().replace(/^(scene|request): /u, '');
  const [, place = '', reason = line] = /^(\/\S*): (.*)$/su.exec(line) ?? [];
  const [, number] = /^\/polygons\/(\d+)/u.exec(place) ?? [];
  const polygon = number === undefined ? undefined : polygons[Number(number)];
  return { polygon: polygon?.id ?? (place === '' ? null : place), reason };
}
