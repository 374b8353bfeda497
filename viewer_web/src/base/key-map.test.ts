import { afterEach, describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import { KeyMap, keyMap, keyName, liveKey, withKey } from './key-map.js';

describe('the keys of one letter', () => {
  it('mean themselves at first', () => {
    const map = new KeyMap();
    expect([map.pressed('X'), map.meant('KeyX'), map.meant('Comma'), map.word]).toEqual([
      'X',
      'KeyX',
      'Comma',
      '',
    ]);
  });

  it('can be exchanged, so that each has one command', () => {
    const map = new KeyMap();
    map.assign('X', 'V');
    expect([map.pressed('X'), map.pressed('V')]).toEqual(['V', 'X']);
    expect([map.meant('KeyV'), map.meant('KeyX')]).toEqual(['KeyX', 'KeyV']);
    map.assign('X', 'K');
    expect([map.meant('KeyK'), map.meant('KeyX'), map.meant('KeyV')]).toEqual([
      'KeyX',
      'KeyV',
      'KeyK',
    ]);
    map.assign('V', 'V');
    map.assign('X', 'X');
    expect(map.word).toBe('');
  });

  it('can be turned off, but keys with names and the space bar still work', () => {
    const map = new KeyMap();
    map.isOff = true;
    const allowed = ['x', '?', ',', '+', '5', ' ', 'ArrowLeft', 'Escape', 'Home'].filter((key) =>
      map.allows({ key }),
    );
    expect(allowed).toEqual([' ', 'ArrowLeft', 'Escape', 'Home']);
  });

  it.each(['', 'off', 'VX.XV', 'off.KX.VK.XV'])('are in an address as %j', (word) => {
    const map = new KeyMap();
    map.word = word;
    expect(map.word).toBe(word);
  });

  it.each(['x', 'XV', 'XV.BV', '<b>', 'XVV.VX', 'off.XK'])(
    'are not what a stranger has put there: %j',
    (word) => {
      const map = new KeyMap();
      map.word = word;
      expect(map.word).toBe(word.startsWith('off') ? 'off' : '');
    },
  );
});

describe('the name of a key', () => {
  afterEach(() => keyMap.reset());

  it('is that of the assigned letter', () => {
    keyMap.assign('B', 'K');
    expect(['B', 'Shift B', 'Shift ←', '?'].map(keyName)).toEqual(['K', 'Shift K', 'Shift ←', '?']);
    expect(withKey('Bookmark', 'B')).toBe('Bookmark (K)');
    keyMap.isOff = true;
    expect(withKey('Bookmark', 'B')).toBe('Bookmark');
  });
});

/** All strings in a table that are the same at any step. */
function fixedIn(table: object): readonly string[] {
  return Object.values(table).flatMap((said: unknown) => {
    if (typeof said === 'string') return [said];
    return typeof said === 'object' && said !== null ? fixedIn(said) : [];
  });
}

describe.each(languages)('the text about keys (%s)', (language) => {
  afterEach(() => keyMap.reset());
  const { bookmarks, predict, history, curves } = texts[language];
  const hints = [
    [bookmarks.hint, 'B'],
    [predict.hint, 'Q'],
    [history.hint, 'P'],
    [curves.history.hint, 'P'],
  ] as const;

  it('names the assigned letter, and none when letters are off', () => {
    for (const [hint, name] of hints) {
      expect(hint(liveKey(name))).toMatch(new RegExp(`\\b${name}\\b`, 'u'));
      keyMap.assign(name, 'K');
      expect(hint(liveKey(name))).toMatch(/\bK\b/u);
      keyMap.isOff = true;
      expect(hint(liveKey(name))).not.toMatch(/\b[A-Z]\b|null/u);
      keyMap.reset();
    }
  });

  it('never names a letter that may be reassigned', () => {
    const named = /(?:press|key|нажм\S*|клавиш\S*) [A-Z?]\b/iu;
    expect(fixedIn(texts[language]).filter((said) => named.test(said))).toEqual([]);
  });
});
