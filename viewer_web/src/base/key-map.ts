/** The command keys with one letter, by their default letters. */
export const letters: readonly string[] = 'B C D E F J L N O P Q R S T V W X'.split(' ');

const isLetter = (text: string): boolean => /^[A-Z]$/.test(text);

/**
 * The assignment of letters to commands, and whether single-character keys act outside fields and controls (WCAG 2.1.4).
 * Letters denote places on the keyboard, the same in any language.
 */
export class KeyMap {
  isOff = false;
  /** The letters pressed in place of the default ones. */
  private readonly moved = new Map<string, string>();

  /** The letter to press for a default letter. */
  pressed(letter: string): string {
    return this.moved.get(letter) ?? letter;
  }

  /** The code of the default key for the code of the pressed one. */
  meant(code: string): string {
    const found = [...this.moved].find(([, pressed]) => `Key${pressed}` === code);
    return found === undefined ? code : `Key${found[0]}`;
  }

  /** Assigns another letter to a command. The command of that letter gets the letter that becomes free. */
  assign(letter: string, pressed: string): void {
    if (!isLetter(letter) || !isLetter(pressed)) return;
    const free = this.pressed(letter);
    const other = this.meant(`Key${pressed}`).slice('Key'.length);
    this.set(other, free);
    this.set(letter, pressed);
  }

  /** Whether a key may act wherever the focus is. */
  allows({ key }: Pick<KeyboardEvent, 'key'>): boolean {
    return !this.isOff || key.length !== 1 || key === ' ';
  }

  reset(): void {
    this.isOff = false;
    this.moved.clear();
  }

  /** The form in an address: "off", and pairs of letters, the default one and the one to press. */
  get word(): string {
    const pairs = [...this.moved].map((pair) => pair.join('')).sort();
    return [...(this.isOff ? ['off'] : []), ...pairs].join('.');
  }

  /** Ignores whatever is not a pair, or would give two commands the same key. */
  set word(word: string) {
    this.reset();
    const [first, ...others] = word.split('.');
    this.isOff = first === 'off';
    const pairs = (this.isOff ? others : [first ?? '', ...others]).filter((pair) =>
      /^[A-Z]{2}$/.test(pair),
    );
    const from = pairs.map((pair) => pair.charAt(0));
    const to = pairs.map((pair) => pair.charAt(1));
    const isExchange = [...from].sort().join('') === [...new Set(to)].sort().join('');
    if (isExchange) pairs.forEach((pair) => this.set(pair.charAt(0), pair.charAt(1)));
  }

  private set(letter: string, pressed: string): void {
    if (letter === pressed) this.moved.delete(letter);
    else this.moved.set(letter, pressed);
  }
}

/** The key map of the page. */
export const keyMap = new KeyMap();

/** The current name of a key, such as "Shift B". */
export const keyName = (name: string): string =>
  name.replace(/(?<=^|Shift )[A-Z]$/, (letter) => keyMap.pressed(letter));

/** The same; null if single-character keys are off. */
export const liveKey = (name: string): string | null => (keyMap.isOff ? null : keyName(name));

/** A label with its key, if the key is on. */
export function withKey(label: string, name: string): string {
  const key = liveKey(name);
  return key === null ? label : `${label} (${key})`;
}
