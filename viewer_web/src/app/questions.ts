import { parseArgs } from 'node:util';
import { complaint, texts } from '../i18n/index.js';
import { isLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { moodleXml, usualCount } from '../predict/moodle.js';
import { read } from '../replay/open.js';
import { Unreadable } from '../replay/trace.js';
import type { Trace } from '../replay/trace.js';
import './algorithms.js';
import './start-engine.js';

/**
 * The questions of a trace on standard input as Moodle XML on standard output, as a program:
 *
 *     node vidno-questions.mjs [--language en|ru] [--count N] < trace.jsonl > questions.xml
 *
 * It refuses an invalid input in one line, with status 2, and writes nothing.
 */
class Refused extends Error {}

interface Options {
  readonly language: Language;
  readonly count: number;
}

function optionsOf(args: readonly string[]): Options {
  const { language, count } = parsed(args);
  if (!isLanguage(language)) throw new Refused(`--language: ${language} is not en or ru`);
  if (!/^[1-9]\d{0,3}$/.test(count)) throw new Refused(`--count: ${count} is not from 1 to 9999`);
  return { language, count: Number(count) };
}

function parsed(args: readonly string[]): Readonly<Record<'language' | 'count', string>> {
  const language = { type: 'string', default: 'en' } as const;
  const count = { type: 'string', default: String(usualCount) } as const;
  try {
    return parseArgs({ args: [...args], options: { language, count } }).values;
  } catch (error) {
    throw new Refused((error as Error).message);
  }
}

async function traceFrom(input: AsyncIterable<Buffer<ArrayBuffer>>): Promise<Trace> {
  const parts: Buffer<ArrayBuffer>[] = [];
  for await (const part of input) parts.push(part);
  let trace: Trace | null = null;
  try {
    for await (const part of read(new Blob(parts))) trace = part;
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    throw new Refused(complaint('-', error, 'en'));
  }
  if (trace === null) throw new Error('a file without a trace');
  return trace;
}

async function main(): Promise<void> {
  const { language, count } = optionsOf(process.argv.slice(2));
  const xml = moodleXml(await traceFrom(process.stdin), language, count);
  if (xml === null) throw new Refused(texts.en.predict.moodleNone);
  process.stdout.write(xml);
}

try {
  await main();
} catch (error) {
  if (!(error instanceof Refused)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 2;
}
