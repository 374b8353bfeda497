import type { ChartTexts } from '../../language/chart-texts.js';

export const subjects: ChartTexts['subjects'] = {
  scenes: {
    show: 'Scene',
    showOne: 'Show a single scene to replay one of its runs.',
    fixed: 'float, double…',
    missingSomewhere: (runs) => `Not shown, for not every scene has a number for them: ${runs}.`,
    advice: {
      none: 'No run gets every pixel right.',
      cheapest: (run, cost, amount) =>
        `${run} is the cheapest of those that get every pixel right (${cost} ${amount}).`,
      cheaper: (count, leastWrong, share) =>
        `Runs that are cheaper: ${count}, all of them wrong; the least wrong is ${leastWrong}, in ${share} of the pixels.`,
      safe: 'It decides as exact arithmetic would: it is right in every scene.',
      safer: (run, times) =>
        `Its arithmetic rounds: what is right here may be wrong elsewhere. Right in every scene, and the cheapest of that kind, is ${run}, at ${times} the cost.`,
      others: (runs) => `The cheapest right runs of the other methods, beside it: ${runs}.`,
      neverRight: (methods) => `Right under no kernel: ${methods}.`,
    },
  },
  surfaces: {
    show: 'Surface',
    showOne: 'Show a single surface to replay one of its runs.',
    fixed: 'as given',
    missingSomewhere: (runs) => `Not shown, for not every surface was sampled so: ${runs}.`,
    advice: {
      none: 'No run that is shown draws every column right.',
      cheapest: (run, cost, amount) =>
        `“${run}” is the cheapest of those that draw every column right (${cost} ${amount}).`,
      cheaper: (count, leastWrong, share) =>
        `Runs that are cheaper: ${count}, all of them wrong; the least wrong is “${leastWrong}”, in ${share} of the columns.`,
      safe: 'Its arithmetic decides as exact arithmetic would, on every surface.',
      safer: (run, times) =>
        `Its arithmetic rounds: what is decided right here may be decided wrong elsewhere. Always decided right, and the cheapest of that kind, is “${run}”, at ${times} the cost.`,
      others: (runs) => `The cheapest right runs that sample otherwise, beside it: ${runs}.`,
      neverRight: (samplings) => `Right under no kernel: ${samplings}.`,
    },
  },
};
