export type { Piece, Region } from '../trace/values.js';

/** Lines at which loops are closed: a fault there is caused by rounding, and the run continues. */
export const isOpenOutline = (label: string): boolean => ['RC4', 'RC5', 'SP3'].includes(label);
