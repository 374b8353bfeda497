/** The effect of a key, or why it has none. */
export interface NewsTexts {
  readonly panel: (name: string) => string;
  readonly presented: string;
  readonly notPresented: string;
  readonly noSolid: string;
  readonly tooManySolid: string;
  readonly answerFirst: string;
  readonly noComparison: string;
}

/** The texts of the map of keys. */
export interface KeyTexts {
  readonly everywhere: string;
  readonly everywhereHint: string;
  readonly change: (use: string) => string;
  readonly changeHint: string;
  readonly reset: string;
}

export type KeyUse =
  | 'step'
  | 'ten'
  | 'over'
  | 'out'
  | 'goal'
  | 'ends'
  | 'play'
  | 'speed'
  | 'part'
  | 'pixel'
  | 'cursor'
  | 'zoom'
  | 'layer'
  | 'mark'
  | 'predict'
  | 'answer'
  | 'bookmark'
  | 'bookmarks'
  | 'toBookmark'
  | 'thing'
  | 'source'
  | 'outline'
  | 'inOutline'
  | 'exact'
  | 'solid'
  | 'turn'
  | 'edit'
  | 'draw'
  | 'undo'
  | 'corner'
  | 'present'
  | 'remote'
  | 'compare'
  | 'parting'
  | 'save'
  | 'reader'
  | 'workbench'
  | 'map';
