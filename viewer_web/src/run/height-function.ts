import type { ConstantNode, FunctionNode, MathNode, OperatorNode, SymbolNode } from 'mathjs';
import {
  addDependencies,
  create,
  divideDependencies,
  equalDependencies,
  largerDependencies,
  largerEqDependencies,
  multiplyDependencies,
  parseDependencies,
  powDependencies,
  smallerDependencies,
  smallerEqDependencies,
  subtractDependencies,
  unaryMinusDependencies,
  unequalDependencies,
} from 'mathjs/number';

/** y as a function of x and z. */
export type HeightFunction = (x: number, z: number) => number;

/** Why a formula is refused: a reason, possibly after its subject and a colon. */
export class FormulaRefused extends Error {}

const reader = create(
  {
    ...addDependencies,
    ...divideDependencies,
    ...equalDependencies,
    ...largerDependencies,
    ...largerEqDependencies,
    ...multiplyDependencies,
    ...parseDependencies,
    ...powDependencies,
    ...smallerDependencies,
    ...smallerEqDependencies,
    ...subtractDependencies,
    ...unaryMinusDependencies,
    ...unequalDependencies,
  },
  // Numbers are equal only if they are identical.
  { relTol: Number.MIN_VALUE, absTol: 0 },
);

type Values = (...values: number[]) => number;

/** The functions that muParser has under the same names, each with its number of arguments. */
const known: Readonly<Record<string, readonly [count: number, of: Values]>> = {
  ...Object.fromEntries(
    (
      [
        ...['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'sinh', 'cosh', 'tanh'],
        ...['asinh', 'acosh', 'atanh', 'exp', 'sqrt', 'abs', 'sign', 'log', 'log2', 'log10'],
      ] as ('sin' | 'log')[]
    ).map((name) => [name, [1, Math[name]]]),
  ),
  ln: [1, Math.log],
  atan2: [2, Math.atan2],
};

/** The functions of one or more arguments. */
const ofMany: Readonly<Record<string, Values>> = {
  min: Math.min,
  max: Math.max,
  sum: (...values) => values.reduce((sum, value) => sum + value),
  avg: (...values) => values.reduce((sum, value) => sum + value) / values.length,
};

const constants: Readonly<Record<string, number>> = { pi: Math.PI, _pi: Math.PI, _e: Math.E };

interface Operator extends MathNode {
  readonly op: string;
}

const operators = ['+', '-', '*', '/', '^', '<', '>', '<=', '>=', '==', '!='];

/** The checks of each kind of node in a formula; they throw errors. */
const takes: Readonly<Record<string, (node: MathNode) => void>> = {
  ParenthesisNode: () => undefined,
  ConditionalNode: () => undefined,
  ConstantNode: (node) => {
    const { value } = node as ConstantNode;
    if (typeof value !== 'number') throw new FormulaRefused(`${String(value)}: no number`);
  },
  SymbolNode: (node) => {
    const { name } = node as SymbolNode;
    if (name !== 'x' && name !== 'z' && !Object.hasOwn(constants, name)) {
      throw new FormulaRefused(`${name}: not known; there are x, z and pi`);
    }
  },
  OperatorNode: (node) => {
    const { op, args, implicit } = node as Pick<OperatorNode, 'args' | 'implicit'> & Operator;
    if (implicit) throw new FormulaRefused('a product is written with *');
    if (!operators.includes(op) || (args.length === 1 && op !== '-')) {
      throw new FormulaRefused(`${op}: not taken here`);
    }
  },
  FunctionNode: (node) => {
    const { fn, args } = node as FunctionNode;
    const { name } = fn;
    const [count] = Object.hasOwn(known, name) ? (known[name] ?? []) : [];
    const isOfMany = Object.hasOwn(ofMany, name) && args.length > 0;
    if (count === undefined && !Object.hasOwn(ofMany, name)) {
      throw new FormulaRefused(`${name}: no such function`);
    }
    if (count !== args.length && !isOfMany) {
      throw new FormulaRefused(`${name}: takes another number of arguments`);
    }
  },
};

function expectTaken(node: MathNode): void {
  const take = takes[node.type];
  if (take === undefined) throw new FormulaRefused('this is more than a formula');
  take(node);
  if (node.type === 'FunctionNode') (node as FunctionNode).args.forEach(expectTaken);
  else node.forEach(expectTaken);
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
 * `||`, `rint` and further constants are not supported here. The last bits of sines and powers may differ.
 */
export function heightFunction(text: string): HeightFunction {
  const node = parsed(text);
  expectTaken(node);
  const formula = node.compile();
  const scope = new Map<string, unknown>(Object.entries({ ...constants, ...ofMany }));
  for (const [name, [, of]] of Object.entries(known)) scope.set(name, of);
  return (x, z) => {
    scope.set('x', x);
    scope.set('z', z);
    return Number(formula.evaluate(scope));
  };
}
