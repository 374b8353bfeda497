import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import type { Event } from '../trace/events.js';
import { noteOf } from './notes.js';

it('the reason of a fault is noted in the language of the page, unless another program wrote it', () => {
  const fault = (reason: string): Event => ({ e: 'fault', at: 'L6', reason });
  const note = (reason: string, language: 'en' | 'ru'): string | null =>
    noteOf(fault(reason), 'zbuffer', texts[language].numbers);
  expect(note('division by zero', 'en')).toBe('division by zero');
  expect(note('division by zero', 'ru')).toBe('деление на нуль');
  expect(note('out of memory', 'ru')).toBe('out of memory');
});
