import { nothing } from 'lit';
import { describe, expect, it } from 'vitest';
import { invitation } from './heading.js';
import type { Session } from './session.js';

const sessionOf = (part: Partial<Session>): Session => part as Session;

describe('the invitation to choose a lesson', () => {
  it('is shown while nothing is open', () => {
    expect(invitation(sessionOf({ trace: null, isOpening: false }), 'en')).not.toBe(nothing);
  });

  it('does not flash while something is being opened', () => {
    expect(invitation(sessionOf({ trace: null, isOpening: true }), 'en')).toBe(nothing);
  });
});
