import type { MappedDecision } from './mapped-decision.js';
import { middle, side } from './places.js';

/** The characters of places whose computed sign is the exact one. */
const sameTwice = /[048]/g;

export type Sign = -1 | 0 | 1;

export interface Cell {
  readonly computed: Sign;
  readonly exact: Sign;
}

/** The answer of a kernel at each place around a point, and the right answer. */
export class SignMap {
  /** One character per place, as the library writes them. */
  constructor(private readonly written: string) {}

  /** The answers at the place `i` steps in x and `j` steps in y from the first. */
  at(i: number, j: number): Cell {
    const digit = Number(this.written[j * side + i]);
    return { computed: signOf(Math.floor(digit / 3)), exact: signOf(digit % 3) };
  }

  /** The answers at the point itself. */
  get centre(): Cell {
    return this.at(middle, middle);
  }

  /** The number of places with a wrong answer. */
  get wrong(): number {
    return this.written.replace(sameTwice, '').length;
  }
}

const signOf = (place: number): Sign => (place - 1) as Sign;

/** The source of maps. The result is null if the kernel has no map, or if another one was requested meanwhile. */
export interface SignMapSource {
  of(decision: MappedDecision, kernel: string): Promise<SignMap | null>;
}
