/** What the library says of a step: one line, or what the run computed and, on a second line, what is so instead. */
export type Stated = string;

/** Whether something else is so than the run computed. */
export const isCorrected = (text: Stated): boolean => text.includes('\n');

export const inOneLine = (text: Stated): string => text.replace('\n', ' ');
