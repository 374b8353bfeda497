import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { liveKey } from '../base/key-map.js';

/** The key beside a button with the same function; nothing if single-character keys are off. */
export function kbd(name: string): TemplateResult | typeof nothing {
  const key = liveKey(name);
  return key === null ? nothing : html`<kbd>${key}</kbd>`;
}
