/** The keys of one letter, by what they do as long as nobody has changed that. */
export const letters: readonly string[] = 'B C D E F J L N O P Q R S T V W X'.split(' ');

const isLetter = (text: string): boolean => /^[A-Z]$/.test(text);

/**
 * Which letters do what they do, and whether keys of one character do anything unless what has the focus means them
 * (WCAG 2.1.4). Letters are places on the keyboard, the same in any language.
 */
export class KeyMap {
  isOff = false;
  /** Where another letter is pressed instead. */
  private readonly moved = new Map<string, string>();

  /** The letter to be pressed for one. */
  pressed(letter: string): string {
    return this.moved.get(letter) ?? letter;
  }

  /** The code of the key that is meant by the code of the one that was pressed. */
  meant(code: string): string {
    const found = [...this.moved].find(([, pressed]) => `Key${pressed}` === code);
    return found === undefined ? code : `Key${found[0]}`;
  }

  /** Another letter for what a letter does; what that one did goes to the letter that is free now. */
  assign(letter: string, pressed: string): void {
    if (!isLetter(letter) || !isLetter(pressed)) return;
    const free = this.pressed(letter);
    const other = this.meant(`Key${pressed}`).slice('Key'.length);
    this.set(other, free);
    this.set(letter, pressed);
  }

  /** Whether a key may do something wherever the focus is. */
  allows({ key }: Pick<KeyboardEvent, 'key'>): boolean {
    return !this.isOff || key.length !== 1 || key === ' ';
  }

  reset(): void {
    this.isOff = false;
    this.moved.clear();
  }

  /** As an address holds it: "off", and pairs of letters, the second to be pressed for the first. */
  get word(): string {
    const pairs = [...this.moved].map((pair) => pair.join('')).sort();
    return [...(this.isOff ? ['off'] : []), ...pairs].join('.');
  }

  /** What is no pair, or would give two letters the same key, is left out. */
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

/** That of the page. */
export const keyMap = new KeyMap();

/** The name of a key as it is now, such as "Shift B". */
export const keyName = (name: string): string =>
  name.replace(/(?<=^|Shift )[A-Z]$/, (letter) => keyMap.pressed(letter));

/** The same, where keys of one character do something. */
export const liveKey = (name: string): string | null => (keyMap.isOff ? null : keyName(name));

/** A label with its key, where that does something. */
export function withKey(label: string, name: string): string {
  const key = liveKey(name);
  return key === null ? label : `${label} (${key})`;
}
