import { oneOf, whole } from './check.js';
import { told } from './decisions.js';
import { kind } from './kind.js';
import { num } from './values.js';

/** Where the centre line of a row meets a polygon, or a visible region. */
export const row = kind(oneOf('F2', 'PR1'), 's', {
  row: whole,
  left: num,
  right: num,
  first: whole,
  end: whole,
  ...told,
});
