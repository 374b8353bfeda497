export const bookmarks = {
  title: 'Bookmarks',
  add: (step: number): string => `Bookmark step ${step}`,
  edit: (step: number): string => `Note of step ${step}`,
  placeholder: 'a note',
  goTo: (step: number): string => `Go to step ${step}`,
  remove: (step: number): string => `Remove the bookmark of step ${step}`,
  count: (n: number, most: number): string => `${n} of ${most}`,
  full: (most: number): string => `A link holds at most ${most} bookmarks: remove one first.`,
  long: (most: number): string => `A note has at most ${most} characters.`,
  /** Includes the key if single-character keys are on. */
  hint: (key: string | null): string =>
    `${key === null ? 'Bookmark' : `Press ${key} to bookmark`} the step that is shown, with a note. Enter ends the note.`,
  linked: 'The link to this page contains them: copy it from the address bar and send it.',
  /** Replaces it for a page on disk, whose address works for nobody else. */
  onDisk: 'To send them, save the page: the button “Save page” is on the tab “Scene”.',
  unlinked:
    'They last until another trace is opened, because a link cannot contain your file. “Save page” on the tab “Scene” keeps them.',
};
