import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import temml from 'temml';
import { withTerms } from '../elements/term.js';
import { glued, withoutBadBreaks } from './glue.js';
import type { Glued } from './glue.js';
import type { Inline, Inlines, PinLink } from './story.js';
import { withoutTerms } from './context.js';
import type { TextContext } from './context.js';

/** A TeX formula as MathML, on a line of its own or in text. Invalid TeX is shown as written. */
export function formula(tex: string, isOnItsOwn = false): TemplateResult {
  return html`${guard([tex, isOnItsOwn], () => mathOf(tex, isOnItsOwn))}`;
}

function mathOf(tex: string, displayMode: boolean): Node | TemplateResult {
  const box = document.createElement('span');
  try {
    temml.render(tex, box, { displayMode, throwOnError: true });
    return box.firstChild ?? html``;
  } catch {
    return html`<code class="tex">${tex}</code>`;
  }
}

type InlineTemplate = string | TemplateResult;

/** Code of at most this many characters stays on one line: a line must not end after the hyphens of an option. */
const longestWhole = 24;

/** The inlines of a text as templates. Without a context there are no links, as in a table of contents. */
export function inlines(text: Inlines, context: TextContext | null): readonly InlineTemplate[] {
  return glued(text).flatMap((inline) => {
    if (typeof inline !== 'string') return [templateOf(inline, context)];
    const words = withoutBadBreaks(inline);
    return context?.terms ? withTerms(words, context.terms) : [words];
  });
}

function templateOf(
  inline: Exclude<Inline, string> | Glued,
  context: TextContext | null,
): InlineTemplate {
  switch (inline.is) {
    case 'emphasis':
      return html`<em>${inlines(inline.text, context)}</em>`;
    case 'strong':
      return html`<strong>${inlines(inline.text, context)}</strong>`;
    case 'code':
      return html`<code class=${inline.text.length > longestWhole ? nothing : 'glued'}
        >${inline.text}</code
      >`;
    case 'formula':
      return formula(inline.tex);
    case 'glued':
      return html`<span class="glued">${inline.before}${formula(inline.tex)}${inline.after}</span>`;
    case 'pin':
    case 'lesson':
    case 'link':
      // A link is a control already, and contains no other.
      return link(inline, inlines(inline.text, context && withoutTerms(context)), context);
  }
}

function link(
  inline: Extract<Inline, { readonly is: 'pin' | 'lesson' | 'link' }>,
  words: readonly InlineTemplate[],
  context: TextContext | null,
): TemplateResult {
  if (context === null) return html`${words}`;
  if (inline.is === 'pin') return pinLink(inline, words, context);
  if (inline.is === 'link') {
    return html`<a class="link" href=${inline.url} target="_blank" rel="noopener noreferrer"
      >${words}</a
    >`;
  }
  const address = context.addressOf(inline.id);
  return address === null ? html`${words}` : html`<a class="lesson" href=${address}>${words}</a>`;
}

function pinLink(
  link: PinLink,
  words: readonly InlineTemplate[],
  context: TextContext,
): TemplateResult {
  const { lesson, story, texts, current, addressOf, runOf, isCopy = false } = context;
  const place = story.places.get(link);
  const pin = lesson.pins.get(link.pin);
  if (place === undefined || pin === undefined) return html`${words}`;
  if (isCopy) return html`<span class="pin" data-step=${texts.step(pin.step)}>${words}</span>`;
  return html`<a
    class="pin"
    data-place=${place}
    data-step=${texts.step(pin.step)}
    title=${texts.pin(pin.step, runOf(pin))}
    href=${addressOf(lesson.id, place) ?? nothing}
    aria-current=${place === current ? 'step' : nothing}
    >${words}</a
  >`;
}

/** The plain words, for screen readers. */
export function plainWords(text: Inlines): string {
  return text
    .map((inline) => {
      if (typeof inline === 'string') return inline;
      if (inline.is === 'formula') return inline.tex;
      return inline.is === 'code' ? inline.text : plainWords(inline.text);
    })
    .join('');
}
