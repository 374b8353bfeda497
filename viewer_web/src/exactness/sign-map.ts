import type { MappedDecision } from './mapped-decision.js';
import { middle, side } from './places.js';

/** The characters of places whose computed sign is the exact one. */
const sameTwice = /[048]/g;

export type Sign = -1 | 0 | 1;

export interface Cell {
  readonly computed: Sign;
  readonly exact: Sign;
}

/** What a kernel answers at each place around a point, and what is right. */
export class SignMap {
  /** A character a place, as the library gives them. */
  constructor(private readonly written: string) {}

  /** Of a place so many steps in x from the first, and in y. */
  at(i: number, j: number): Cell {
    const digit = Number(this.written[j * side + i]);
    return { computed: signOf(Math.floor(digit / 3)), exact: signOf(digit % 3) };
  }

  /** Of the point itself. */
  get centre(): Cell {
    return this.at(middle, middle);
  }

  /** At how many places the answer is wrong. */
  get wrong(): number {
    return this.written.replace(sameTwice, '').length;
  }
}

const signOf = (place: number): Sign => (place - 1) as Sign;

/** Where maps come from; null if there is none under this kernel, or if another was asked for meanwhile. */
export interface SignMapSource {
  of(question: MappedDecision, kernel: string): Promise<SignMap | null>;
}
