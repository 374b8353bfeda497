import type { SceneTexts } from '../../language/texts.js';
import words from '../../trace/format-words.json' with { type: 'json' };
import { meshReasons } from './mesh-reasons.js';
import { short } from './numbers.js';
import { traceReasons } from './trace-reasons.js';

export const scene: SceneTexts = {
  scene: 'Сцена',
  edit: 'Править',
  howOutside:
    'Двигайте вершину или, за ребро, весь многоугольник. Часть вершин вне изображения: чтобы их увидеть, уменьшите его.',
  how: 'Вершину двигайте за неё саму, весь многоугольник — за ребро. На вершине действуют клавиши: они в списке «Клавиши».',
  run: 'Прогон',
  method: 'метод',
  kernel: 'числа',
  edition: 'текст',
  detail: 'подробность',
  details: { windows: 'окна', polygons: 'многоугольники', signs: 'знаки' },
  check: 'сверять все решения',
  undo: 'Отменить',
  redo: 'Вернуть',
  draw: 'Нарисовать многоугольник',
  drawing:
    'Отмечайте вершины. Чтобы закончить, отметьте снова первую или нажмите Enter; Backspace убирает последнюю, Esc отменяет рисование.',
  drawHere: 'Место вершины: стрелки двигают его, пробел ставит вершину',
  clear: 'Новая',
  clearHint: 'Убирает все многоугольники',
  save: 'Сохранить',
  saveHint: 'Сохраняет сцену в файл',
  link: 'Ссылка',
  linkHint: 'Копирует ссылку со сценой, способом прогона и этим шагом',
  linkCopied: 'Ссылка скопирована.',
  linkTooLong:
    'Сцена слишком велика для ссылки. Вместо неё кнопка «Страница» сохранит файл, который откроется на этом шаге.',
  page: 'Страница',
  pageHint:
    'Сохраняет эту страницу в файл для отправки: с тем, что показано, этим шагом и закладками',
  pageSaved: 'Сохранена страница, которая открывается на этом месте. Отправьте файл.',
  discard: {
    title: (name) => `Потерять правки${name === '' ? '' : ` сцены «${name}»`}?`,
    text: 'Сцена изменена, и сейчас её место займёт другое.',
    stay: 'Остаться',
    save: 'Сохранить сцену и перейти',
    discard: 'Не сохранять',
  },
  area: 'Область',
  areaFields: { x: 'слева', y: 'сверху', width: 'ширина', height: 'высота' },
  background: 'фон',
  polygons: 'Многоугольники',
  order: 'При равных глубинах виден первый',
  colorOf: (id) => `цвет ${id}`,
  nameOf: (id) => `имя ${id}`,
  needsName: 'У многоугольника должно быть имя.',
  isTaken: (id) => `Имя ${id} уже у другого многоугольника.`,
  cornersOf: (id) => `вершины ${id}`,
  earlier: (id) => `${id} раньше`,
  later: (id) => `${id} позже`,
  remove: (id) => `Удалить ${id}`,
  corner: (id, n, x, y, z) =>
    `${id}, вершина ${n}: x ${short(x)}, y ${short(y)}, глубина ${short(z)}`,
  coordinate: (axis, n) => `${axis} вершины ${n}`,
  depth: 'глубина z',
  depthOf: (id) => `глубина ${id}`,
  tilt: 'Глубина каждой вершины',
  follows: 'Следует из глубин первых трёх вершин',
  split: (n) => `Добавить вершину после вершины ${n}`,
  removeCorner: (n) => `Удалить вершину ${n}`,
  refused: (polygon, reason) => (polygon === null ? reason : `${polygon}: ${reason}`),
  formula: (reason) => `Формула: ${reason}`,
  stands: 'Показан прежний прогон.',
  at: (line, column) => `строка ${line}, символ ${column}`,
  missing: (key) => `нет поля «${key}»`,
  placeInFile: (kind, number) =>
    `${{ line: 'строка', face: 'грань', vertex: 'вершина' }[kind]} ${number}`,
  leftOut: (where, what, times) =>
    `${where}: пропущено: ${what}${times > 1 ? ` (всего ${times}, здесь впервые)` : ''}`,
  reasons: {
    ...traceReasons,
    ...meshReasons,
    [words.other.en]: words.other.ru,
    [words.newer.en]: words.newer.ru,
    [words.older.en]: words.older.ru,
    'not valid JSON': 'это не JSON',
    'unknown key': 'такого поля нет',
    'the key occurs twice': 'поле встречается дважды',
    'the id occurs twice': 'имя встречается дважды',
    'not an object': 'не объект',
    'not an array': 'не список',
    'not a string': 'не строка',
    'unknown word': 'неизвестное слово',
    'neither true nor false': 'не true и не false',
    'not a whole number': 'не целое число',
    'not from {} to {}': 'не от {} до {}',
    'neither a number nor a hexadecimal one as text, such as "0x1.8p-3"':
      'ни число, ни шестнадцатеричное число вида "0x1.8p-3"',
    'not two coordinates': 'не две координаты',
    'not three coordinates': 'не три координаты',
    'not a colour of the form "#rrggbb"': 'не цвет вида "#rrggbb"',
    'not a hexadecimal number such as "0x1.8p-3"':
      'не число: пишется 2.5, а шестнадцатеричное — "0x1.8p-3"',
    'the number is beyond the range of doubles': 'число вне диапазона double',
    'nested too deeply': 'слишком глубокая вложенность',
    empty: 'пусто',
    'longer than {} bytes': 'длиннее {} байт',
    'the id occurs twice; a polygon without an id gets its position':
      'имя встречается дважды: без имени многоугольник называется по номеру',
    'more than {} polygons': 'многоугольников больше {}',
    'cut into more than {} polygons': 'при разрезании получается больше {} многоугольников',
    'more than {} curves': 'кривых больше {}',
    'together more than {} samples': 'всех отсчётов больше {}',
    '"window" is missing, which a camera needs': 'нет поля «window», а камере оно нужно',
    '"window" is missing, and there are no vertices to derive it from':
      'нет ни поля «window», ни вершин, по которым его можно найти',
    '"window" is missing, and there are no samples to derive it from':
      'нет ни поля «window», ни отсчётов, по которым его можно найти',
    'there may be more faults: reading ended here':
      'возможно, есть и другие: чтение на этом закончено',
    '"window" is missing, and the samples reach too far for one':
      'нет поля «window», а отсчёты заходят слишком далеко, чтобы найти его по ним',
    'neither "perspective" nor "orthographic"': 'не "perspective" и не "orthographic"',
    'eye and target are one point': 'eye и target — одна точка',
    'up does not point aside from the direction of view': 'up направлен вдоль взгляда',
    'fov is not between 0 and 180 degrees': 'fov не между 0 и 180 градусами',
    'near is not greater than 0': 'near не больше 0',
    'height is not greater than 0': 'height не больше 0',
    'near is not less than far': 'near не меньше far',
    'out of the range of doubles': 'вне диапазона double',
    'not greater than 0': 'не больше 0',
    'not columns and rows': 'не столбцы и строки',
    'not two numbers': 'не два числа',
    'the two numbers are equal': 'дважды одно и то же число',
    'curve {} is over the columns {} to {}, and the window has {} to {}':
      'кривая {} занимает столбцы от {} до {}, а в окне — от {} до {}',
    'has no function that could be sampled in other ways':
      'функции нет, поэтому других отсчётов взять нельзя',
    'fewer than two samples': 'меньше двух отсчётов',
    'not a column and a y': 'не столбец и ордината',
    'not finite at any sample': 'не имеет конечного значения ни в одном отсчёте',
    'no sample has a y': 'ни у одного отсчёта нет ординаты',
    'not right of the sample before': 'не правее предыдущего отсчёта',
    'no {} of this name': 'такого имени нет: {}',
    'not one of {}': 'не одно из {}',
    'no such edition': 'такого текста нет',
    'draws no surface': 'не рисует поверхностей',
    'draws a surface, and the scene is of polygons':
      'рисует поверхность, а сцена — из многоугольников',
    'the kernel does not run this method and edition':
      'с этими числами метод с этим текстом не выполняется',
    'not two whole numbers': 'не два целых числа',
    'shows nothing': 'ничего не показывает',
    'not a curve and an x': 'не кривая и x',
    'not true': 'не true',
    'not positive': 'не положительное число',
    'no scene shows it': 'ни одна сцена этого не показывает',
    'the scene is too wide for a grid of 1/2^{} pixel; grid:{} is the finest that fits':
      'сцена слишком широка для сетки с шагом 1/2^{} пикселя; самая мелкая подходящая — grid:{}',
    'the scene is too wide for a grid of 1/2^{} pixel; none fits':
      'сцена слишком широка для сетки с шагом 1/2^{} пикселя; не подходит ни одна',
    'not finite': 'не конечное число',
    'fewer than three vertices': 'меньше трёх вершин',
    'z outside -1 to 1': 'глубина не от −1 до 1',
    'not planar': 'не плоский',
    'not planar: in the plane of {}, {} and {} this vertex would have {} = {}; triangles are always planar':
      'не плоский: в плоскости {}, {} и {} у этой вершины было бы {} = {}; треугольники всегда плоские',
    'not convex, and with more than {} vertices it is not cut':
      'не выпуклый, а если вершин больше {}, он не разрезается',
    'not convex, and the edges from {} and {} cross; cut the polygon there':
      'не выпуклый, и рёбра от {} и {} пересекаются; разрежьте многоугольник там',
    'not convex, and the outline touches itself; cut the polygon there':
      'не выпуклый, и контур касается себя; разрежьте многоугольник там',
    'has an edge that no other polygon shares':
      'у него есть ребро, которое не принадлежит никакому другому: нужны замкнутые выпуклые тела',
    'goes along an edge in the same direction as another polygon':
      'идёт вдоль ребра в ту же сторону, что и другой: нужны замкнутые выпуклые тела',
    'has no area': 'у него нет площади',
    'is not planar to the last digit': 'не плоский до последнего знака',
    'has a vertex of another one in front of it: its body is not convex, or its vertices are in the opposite order':
      'перед ним лежит вершина другого: его тело не выпукло или обход обратный',
    'no number': 'не число',
    'beyond the range of double': 'вне диапазона double',
    'not known; there are x, z, pi and e': 'неизвестно; есть x, z, pi и e',
    'the formula gives its value; there are x, z, pi and e':
      'его значение и даёт формула; есть x, z, pi и e',
    'a product is written with *': 'произведение пишется со знаком *',
    'no such function': 'такой функции нет',
    'takes its argument in parentheses': 'аргумент пишется в скобках',
    'takes one argument': 'у неё один аргумент',
    'takes one argument; a decimal fraction has a point':
      'у неё один аргумент; десятичная дробь пишется с точкой',
    'takes one argument or more': 'у неё хотя бы один аргумент',
    'takes two arguments': 'у неё два аргумента',
    'takes two arguments; a decimal fraction has a point':
      'у неё два аргумента; десятичная дробь пишется с точкой',
    'a comma is only between arguments; a decimal fraction has a point':
      'запятая стоит только между аргументами; десятичная дробь пишется с точкой',
    'a comparison has two sides; && joins two comparisons':
      'у сравнения две стороны; два сравнения соединяет &&',
    'equality is written ==': 'равенство пишется ==',
    'an absolute value is written abs(x)': 'модуль пишется abs(x)',
    'longer than {} characters': 'длиннее {} символов',
    'it is empty': 'она пуста',
    'it ends too early': 'обрывается',
    'not understood': 'непонятно',
  },
  more: (n) => `и ещё ${n}; показаны первые`,
};
