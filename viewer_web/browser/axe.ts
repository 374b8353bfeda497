import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from 'playwright-core';
import { settled } from './browser.js';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface AxeRun {
  readonly run: (
    context: Document,
    options: object,
  ) => Promise<{ violations: { id: string; nodes: { html: string }[] }[] }>;
}

interface Rules {
  readonly type: 'tag' | 'rule';
  readonly values: readonly string[];
}

const wcag: Rules = {
  type: 'tag',
  values: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'],
};
const colours: Rules = { type: 'rule', values: ['color-contrast', 'link-in-text-block'] };

/** Violations of WCAG 2.2 AA on the page, in both themes. The page must be in the light one. */
export async function violations(page: Page): Promise<readonly string[]> {
  await page.evaluate(axe);
  const light = await broken(page, wcag);
  // Only the colours differ between the themes.
  await page.emulateMedia({ colorScheme: 'dark' });
  await settled(page);
  const dark = await broken(page, colours);
  await page.emulateMedia({ colorScheme: 'light' });
  return [...light, ...dark.map((each) => `in the dark: ${each}`)];
}

function broken(page: Page, rules: Rules): Promise<readonly string[]> {
  return page.evaluate(async (runOnly) => {
    const { axe: run } = window as unknown as { axe: AxeRun };
    const results = await run.run(document, {
      runOnly,
      // A list of everything that is right would take a tenth of the time.
      resultTypes: ['violations'],
    });
    return results.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`);
  }, rules);
}
