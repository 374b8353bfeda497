import type {
  ConditionalNode,
  ConstantNode,
  FunctionNode,
  MathNode,
  OperatorNode,
  ParenthesisNode,
  SymbolNode,
} from 'mathjs';
import { create, parseDependencies } from 'mathjs/number';

/** y as a function of x and z. */
export type HeightFunction = (x: number, z: number) => number;

/** Why a formula is refused: a reason, possibly after its subject and a colon. */
export class FormulaRefused extends Error {}

const reader = create({ ...parseDependencies });

type Values = (...values: number[]) => number;

const rounded = [
  ...(['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'sinh', 'cosh', 'tanh'] as const),
  ...(['asinh', 'acosh', 'atanh', 'exp', 'log', 'log2', 'log10'] as const),
];

/** The functions that libraries round differently: those of the browser, or for the npm package those of the program. */
export type Elementary = Pick<Math, (typeof rounded)[number] | 'atan2' | 'pow'>;

/** The functions that muParser has under the same names, with one argument or two. */
function knownIn(elementary: Elementary): ReadonlyMap<string, Values> {
  const same = (['sqrt', 'abs', 'sign'] as const).map((name) => [name, Math[name]] as const);
  return new Map<string, Values>([
    ...rounded.map((name) => [name, elementary[name]] as const),
    ...same,
    ['ln', elementary.log],
    ['atan2', elementary.atan2],
  ]);
}

/** The functions of one or more arguments. */
const ofMany: ReadonlyMap<string, Values> = new Map<string, Values>([
  ['min', Math.min],
  ['max', Math.max],
  ['sum', (...values) => values.reduce((sum, value) => sum + value)],
  ['avg', (...values) => values.reduce((sum, value) => sum + value) / values.length],
]);

const constants: ReadonlyMap<string, number> = new Map([
  ['pi', Math.PI],
  ['_pi', Math.PI],
  ['_e', Math.E],
]);

const operators: ReadonlyMap<string, Values> = new Map<string, Values>(
  Object.entries({
    '+': (a: number, b: number) => a + b,
    '-': (a: number, b: number) => a - b,
    '*': (a: number, b: number) => a * b,
    '/': (a: number, b: number) => a / b,
    '<': (a: number, b: number) => Number(a < b),
    '>': (a: number, b: number) => Number(a > b),
    '<=': (a: number, b: number) => Number(a <= b),
    '>=': (a: number, b: number) => Number(a >= b),
    '==': (a: number, b: number) => Number(a === b),
    '!=': (a: number, b: number) => Number(a !== b),
  }),
);

/** Makes a function of each kind of node in a formula, or throws. */
class Compiler {
  private readonly known: ReadonlyMap<string, Values>;

  constructor(private readonly elementary: Elementary) {
    this.known = knownIn(elementary);
  }

  compiled(node: MathNode): HeightFunction {
    switch (node.type) {
      case 'ParenthesisNode':
        return this.compiled((node as ParenthesisNode).content);
      case 'ConstantNode':
        return this.constant((node as ConstantNode).value);
      case 'SymbolNode':
        return this.symbol((node as SymbolNode).name);
      case 'ConditionalNode':
        return this.conditional(node as ConditionalNode);
      case 'OperatorNode':
        return this.operator(node as OperatorNode);
      case 'FunctionNode':
        return this.call(node as FunctionNode);
      default:
        throw new FormulaRefused('this is more than a formula');
    }
  }

  private constant(value: unknown): HeightFunction {
    if (typeof value !== 'number') throw new FormulaRefused(`${String(value)}: no number`);
    return () => value;
  }

  private symbol(name: string): HeightFunction {
    if (name === 'x') return (x) => x;
    if (name === 'z') return (_x, z) => z;
    const value = constants.get(name);
    if (value === undefined) throw new FormulaRefused(`${name}: not known; there are x, z and pi`);
    return () => value;
  }

  private conditional({ condition, trueExpr, falseExpr }: ConditionalNode): HeightFunction {
    const [asked, then, otherwise] = [condition, trueExpr, falseExpr].map((each) =>
      this.compiled(each),
    ) as [HeightFunction, HeightFunction, HeightFunction];
    return (x, z) => (asked(x, z) === 0 ? otherwise(x, z) : then(x, z));
  }

  private operator(node: OperatorNode): HeightFunction {
    const { op, args, implicit } = node as Pick<OperatorNode, 'args' | 'implicit'> & { op: string };
    if (implicit) throw new FormulaRefused('a product is written with *');
    if (op === '-' && args.length === 1) return this.applied((value) => -value, args);
    const of = op === '^' ? this.elementary.pow : operators.get(op);
    if (of === undefined || args.length !== 2) throw new FormulaRefused(`${op}: not taken here`);
    return this.applied(of, args);
  }

  private call({ fn: { name }, args }: FunctionNode): HeightFunction {
    const known = this.known.get(name);
    const many = ofMany.get(name);
    const of = known ?? many;
    if (of === undefined) throw new FormulaRefused(`${name}: no such function`);
    const count = name === 'atan2' ? 2 : 1;
    if (known === undefined ? args.length === 0 : args.length !== count) {
      throw new FormulaRefused(`${name}: takes another number of arguments`);
    }
    return this.applied(of, args);
  }

  private applied(of: Values, args: readonly MathNode[]): HeightFunction {
    const each = args.map((arg) => this.compiled(arg));
    return (x, z) => of(...each.map((arg) => arg(x, z)));
  }
}

/** The characters that both parsers of formulas support. */
const letters = /^[\w\s.+\-*/^()<>=!?:,]+$/;

function parsed(text: string): MathNode {
  if (!letters.test(text)) throw new FormulaRefused('empty, or with signs that no formula has');
  try {
    return reader.parse(text);
  } catch (error) {
    const at = (error as { readonly char?: number }).char ?? 0;
    const unread = text.slice(Math.max(at - 1, 0)).trim();
    throw new FormulaRefused(unread === '' ? 'it ends too early' : `${unread}: not understood`);
  }
}

/**
 * Parses a function. The program's muParser accepts the same texts, with the same meaning. muParser's assignments, `&&`,
 * `||`, `rint` and further constants are not supported here.
 */
export function heightFunction(text: string, elementary: Elementary): HeightFunction {
  return new Compiler(elementary).compiled(parsed(text));
}
