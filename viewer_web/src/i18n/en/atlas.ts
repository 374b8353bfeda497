export const atlas = {
  title: 'Atlas of failures',
  /** The label of the button that opens it. */
  short: 'Atlas',
  close: 'Close',
  show: 'Show',
  all: 'all',
  kinds: {
    rounding: 'rounding',
    printed: 'errors of the printed text',
    mistake: 'usual mistakes',
    limit: 'limits of a method',
    test: 'without a scene',
  },
  /** Instead of a picture. */
  noScene: 'no scene can show it',
  remedy: 'Remedy',
  /** It opens to the reasons. */
  unproved: 'Why the picture has no proof',
  /** The step at which a failure shows, and the defect there. */
  at: (step: string, there: string): string => `Step ${step}: ${there}`,
  goTo: 'Go to the step',
  compare: 'Compare with the remedy',
  leave: 'Leave the comparison',
  /** The panel of the open failure. */
  forget: 'Hide',
};
