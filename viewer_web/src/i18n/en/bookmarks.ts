import type { BookmarkTexts } from '../../language/texts.js';

export const bookmarks: BookmarkTexts = {
  title: 'Bookmarks',
  add: (step) => `Bookmark step ${step}`,
  edit: (step) => `Note of step ${step}`,
  placeholder: 'a note',
  goTo: (step) => `Go to step ${step}`,
  remove: (step) => `Remove the bookmark of step ${step}`,
  count: (n, most) => `${n} of ${most}`,
  full: (most) => `A link holds at most ${most} bookmarks: remove one first.`,
  long: (most) => `A note has at most ${most} characters.`,
  hint: (key) =>
    `${key === null ? 'Bookmark' : `Press ${key} to bookmark`} the step that is shown, with a note. Enter ends the note.`,
  linked: 'The link to this page contains them: copy it from the address bar and send it.',
  onDisk: 'To send them, save the page: the button “Save page” is on the tab “Scene”.',
  unlinked:
    'They last until another trace is opened, because a link cannot contain your file. “Save page” on the tab “Scene” keeps them.',
};
