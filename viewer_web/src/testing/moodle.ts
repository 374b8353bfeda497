/** A choice in Moodle's reading. A number has one option: its value and how far from it an answer may be. */
export interface Choice {
  readonly weight: number;
  readonly type: string;
  readonly options: readonly { readonly html: string; readonly fraction: number }[];
}

/** A question of a file in Moodle's XML format. */
export interface Imported {
  readonly type: string;
  readonly name: string;
  /** The HTML without the choices. */
  readonly html: string;
  readonly choices: readonly Choice[];
  readonly feedback: string;
  readonly files: readonly { readonly name: string; readonly content: string }[];
}

const named: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"' };

/** Replaces the references of XML or HTML by their characters. */
export function decoded(text: string): string {
  return text.replace(/&(?:#(\d+)|(\w+));/g, (whole: string, code?: string, name?: string) =>
    code === undefined ? (named[name ?? ''] ?? whole) : String.fromCharCode(Number(code)),
  );
}

/** The text that a browser shows for some HTML. */
export const shown = (html: string): string => decoded(html.replace(/<[^>]*>/g, ''));

const textIn = (xml: string, name: string): string =>
  decoded(new RegExp(`<${name}[^>]*>\\s*<text>([^<]*)</text>`).exec(xml)?.[1] ?? '');

/** A character after a backslash or an ampersand does not end anything. */
const notQuoted = '(?<!\\\\|&|&amp;)';
const choicePattern = new RegExp(
  `\\{(\\d*):(MULTICHOICE(?:_V)?|NUMERICAL):(.+?)${notQuoted}\\}`,
  'gs',
);

function optionOf(written: string): Choice['options'][number] {
  const [, all, , percent, answer = ''] =
    new RegExp(`^((=)|%(-?\\d+)%)?(.+?)(?:${notQuoted}#.*)?$`, 's').exec(written) ?? [];
  const fraction = all === '=' ? 100 : Number(percent ?? 0);
  return { html: decoded(answer), fraction };
}

function choiceOf([, weight, type = '', written = '']: RegExpExecArray): Choice {
  const options = written.split(new RegExp(`${notQuoted}~`)).map(optionOf);
  return { weight: Number(weight), type, options };
}

/**
 * The questions of a well-formed file, by the rules of https://docs.moodle.org/en/Moodle_XML_format and
 * https://docs.moodle.org/en/Embedded_Answers_(Cloze)_question_type.
 */
export function imported(xml: string): readonly Imported[] {
  return [...xml.matchAll(/<question type="(\w+)">(.*?)<\/question>/gs)].map(
    ([, type = '', question = '']) => {
      const html = textIn(question, 'questiontext');
      const files = question.matchAll(/<file name="([^"]*)"[^>]*>([^<]*)<\/file>/g);
      return {
        type,
        name: textIn(question, type === 'category' ? 'category' : 'name'),
        html: html.replace(choicePattern, ''),
        choices: [...html.matchAll(choicePattern)].map(choiceOf),
        feedback: textIn(question, 'generalfeedback'),
        files: [...files].map(([, name = '', content = '']) => ({ name, content: atob(content) })),
      };
    },
  );
}
