import { LitElement } from 'lit';
import { property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { SceneTexts } from '../language/texts.js';
import type { Act, Editing } from './editor.js';
import type { Sketch } from '../run/sketch.js';

/** Requests an edit from whatever owns the scene, from anywhere in the player. */
export function act(from: EventTarget, detail: Act): void {
  from.dispatchEvent(new CustomEvent<Act>('vidno-act', { detail, bubbles: true, composed: true }));
}

/** Asks to save the whole scene as a file, or to copy a link to it. */
export function ask(from: EventTarget, what: 'vidno-save' | 'vidno-link'): void {
  from.dispatchEvent(new Event(what, { bubbles: true, composed: true }));
}

/** A part of the form of a scene. Its requests are events `vidno-act`. */
export class FormElement extends LitElement {
  @property({ attribute: false }) editing!: Editing;
  @property({ attribute: false }) language: Language = 'en';

  protected get say(): SceneTexts {
    return texts[this.language].scene;
  }

  protected act(what: Act): void {
    act(this, what);
  }

  protected edit(edit: (old: Sketch) => Sketch): void {
    this.act({ do: 'edit', edit });
  }

  /** Uses the typed number, and resets the field to its value if the text is not a number or changes nothing. */
  protected number(event: Event, use: (value: number) => void): void {
    const value = (event.target as HTMLInputElement).valueAsNumber;
    if (Number.isFinite(value)) use(value);
    this.requestUpdate();
  }

  /** A colour changes while the reader picks it, and is undone as a whole. */
  protected color(
    event: Event,
    of: string,
    edit: (color: string) => (old: Sketch) => Sketch,
  ): void {
    const { value } = event.target as HTMLInputElement;
    this.act({ do: 'edit', edit: edit(value), name: `color of ${of}` });
  }
}
