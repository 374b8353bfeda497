/** A lesson with every kind of block and inline, as `vidno lesson build` writes it, over two traces of the test data. */

type Language = 'en' | 'ru';
type Said = Readonly<Record<Language, string>>;

const pin = (name: string, ...text: readonly unknown[]): object => ({ is: 'pin', pin: name, text });
const formula = (tex: string): object => ({ is: 'formula', tex });
const code = (text: string): object => ({ is: 'code', text });
const paragraph = (...text: readonly unknown[]): object => ({ is: 'paragraph', text });
const heading = (level: number, ...text: readonly unknown[]): object => ({
  is: 'heading',
  level,
  text,
});

/** Long enough to make the text scroll. */
const passage: Said = {
  en: 'A window is looked at, and if what shows in it is simple, it is painted; if not, it is split. '.repeat(
    6,
  ),
  ru: 'Окно рассматривают, и если видимое в нём просто, его закрашивают, а если нет — разбивают. '.repeat(
    6,
  ),
};

export const evil = '<img src=x onerror=alert(1)>';

function storyIn(language: Language): object {
  const say = (en: string, ru: string): string => (language === 'en' ? en : ru);
  const words = paragraph(passage[language]);
  return {
    title: [say('From windows to pixels ', 'От окон к пикселям '), evil],
    goals: [[say('split ', 'делить '), code('W13')], [say('count', 'считать')]],
    blocks: [
      words,
      heading(2, say('The first windows', 'Первые окна')),
      words,
      paragraph(
        say('At ', 'На '),
        pin('first', say('the first window', 'первом окне'), ' ', code('W3')),
        say(' the depth is ', ' глубина равна '),
        formula('z = \\frac{1}{2}'),
        say(', no more.', ', не больше.'),
      ),
      words,
      { is: 'formula', tex: 'a x + b y + c z + d = 0' },
      words,
      paragraph(pin('second', say('The second', 'Второй')), '.'),
      words,
      {
        is: 'figure',
        caption: [say('Two windows', 'Два окна')],
        command: 'vidno figure lessons/sample --pin first -o windows.svg',
        file: 'windows.svg',
      },
      {
        is: 'figure',
        caption: [say('Without a drawing', 'Без рисунка')],
        command: 'vidno figure lessons/sample --pin second -o missing.svg',
        file: 'missing.svg',
      },
      heading(3, say('A list', 'Список'), ' ', formula('n')),
      {
        is: 'list',
        ordered: false,
        items: [[paragraph(say('one', 'раз'))], [paragraph({ is: 'emphasis', text: ['2'] })]],
      },
      { is: 'quote', blocks: [paragraph({ is: 'strong', text: [say('Quoted', 'Цитата')] })] },
      {
        is: 'question',
        number: 1,
        blocks: [paragraph(say('How many?', 'Сколько?'))],
        answer: [paragraph(say('Three ', 'Три '), pin('first', say('windows', 'окна')), '.')],
      },
      // An exercise as in a lesson that was built without answers.
      { is: 'exercise', number: 1, blocks: [paragraph(say('Compute it.', 'Вычислите.'))] },
      heading(2, say('The other method', 'Другой метод')),
      paragraph({ is: 'strong', text: [say('Depth', 'Глубина')] }, ' z.'),
      { is: 'listing', names: ['Depth', 'PW7'], edition: 'printed' },
      words,
      paragraph(pin('scanline', say('A scanline', 'Строка растра')), '.'),
      words,
      { is: 'code', language: 'sh', text: 'vidno methods\n' },
      { is: 'code', language: 'cpp', text: 'int i = 0; // <b>' },
      {
        is: 'table',
        head: [['n'], [say('name', 'имя')]],
        align: ['right', ''],
        rows: [[['1'], [code('A')]]],
      },
      paragraph(
        { is: 'lesson', id: 'second', text: [say('The next', 'Следующий')] },
        ', ',
        { is: 'lesson', id: 'nowhere', text: [say('none', 'никакой')] },
        ', ',
        { is: 'link', url: 'https://example.org/', text: [say('elsewhere', 'другое')] },
      ),
      words,
    ],
    figures: {
      'windows.svg':
        '<svg xmlns="http://www.w3.org/2000/svg" width="80" height="60"><rect width="80" height="60"/></svg>',
    },
  };
}

/** The lesson as in its file; `other` replaces some members. */
export function sampleLesson(other: object = {}): object {
  return {
    format: 'vidno-lesson/1',
    id: 'first',
    traces: { run: 'small.warnock.signs.jsonl', depths: 'small.zbuffer.signs.jsonl' },
    pins: {
      first: { run: 'run', step: 5 },
      second: { run: 'run', step: 60 },
      scanline: { run: 'depths', step: 33 },
    },
    minutes: 25,
    prerequisites: [
      { id: 'second', title: { en: 'Lesson second', ru: 'Урок second' } },
      { id: 'nowhere', title: { en: 'Not here', ru: 'Не здесь' } },
    ],
    assumes: { en: 'Lines.', ru: 'Прямые.' },
    sources: [
      {
        authors: 'D. F. Rogers',
        year: '1998',
        title: 'Procedural Elements',
        in: 'McGraw-Hill',
        url: 'https://example.org/rogers',
        chapter: '4',
        translations: { ru: 'Роджерс Д. Основы.' },
      },
    ],
    story: { en: storyIn('en'), ru: storyIn('ru') },
    ...other,
  };
}

/** A lesson of one paragraph. */
export function shortLesson(id: string): object {
  const story = { title: [id], blocks: [paragraph(pin('end', 'The end'), '.')] };
  const traces = { run: 'small.zbuffer.signs.jsonl' };
  return sampleLesson({
    id,
    traces,
    pins: { end: { run: 'run', step: 7 } },
    story: { en: story, ru: story },
  });
}

const trace = (method: string): object => ({
  file: `small.${method}.signs.jsonl`,
  method,
  kernel: 'double',
  edition: 'corrected',
  detail: 'signs',
});

/** The entry of a lesson in `index.json`; without a story's file it has none. */
export function indexEntry(id: string, methods: readonly string[], story?: string): object {
  const title = { en: `Lesson ${id}`, ru: `Урок ${id}` };
  return { id, title, traces: methods.map(trace), ...(story === undefined ? {} : { story }) };
}
