/** What an address names as its trace if it cannot hold what it was made from: a file of the reader's own, or a large scene. */
export const unheld = 'unheld';
