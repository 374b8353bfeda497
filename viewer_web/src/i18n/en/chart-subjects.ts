export const subjects = {
  scenes: {
    show: 'Scene',
    showOne: 'Show a single scene to replay one of its runs.',
    /** The name of a series without a knob. */
    fixed: 'float, double…',
    missingSomewhere: (runs: string): string =>
      `Not shown because some scenes have no number for them: ${runs}.`,
    advice: {
      none: 'No run gets every pixel right.',
      cheapest: (run: string, cost: string, amount: string): string =>
        `${run} is the cheapest of those that get every pixel right (${cost} ${amount}).`,
      cheaper: (count: string, leastWrong: string, share: string): string =>
        `Cheaper runs: ${count}, none of them right. ${leastWrong} comes closest: it is wrong in ${share} of the pixels.`,
      safe: 'It decides as exact arithmetic does, so it is right in every scene.',
      safer: (run: string, times: string): string =>
        `This run rounds: a run that is right here may be wrong elsewhere. The cheapest run that is right in every scene is ${run} (cost: ${times}).`,
      others: (runs: string): string =>
        `The cheapest correct runs of the other methods, compared with it: ${runs}.`,
      neverRight: (methods: string): string => `Not right under any kernel: ${methods}.`,
    },
  },
  surfaces: {
    show: 'Surface',
    showOne: 'Show a single surface to replay one of its runs.',
    /** The name of a series without a knob. */
    fixed: 'as given',
    missingSomewhere: (runs: string): string =>
      `Not shown because some surfaces were not sampled that way: ${runs}.`,
    advice: {
      none: 'No run shown here draws every column right.',
      cheapest: (run: string, cost: string, amount: string): string =>
        `“${run}” is the cheapest of those that draw every column right (${cost} ${amount}).`,
      cheaper: (count: string, leastWrong: string, share: string): string =>
        `Cheaper runs: ${count}, none of them right. “${leastWrong}” comes closest: it is wrong in ${share} of the columns.`,
      safe: 'It decides as exact arithmetic does, on every surface.',
      safer: (run: string, times: string): string =>
        `This run rounds: a decision that is right here may be wrong elsewhere. The cheapest run that always decides correctly is “${run}” (cost: ${times}).`,
      others: (runs: string): string =>
        `The cheapest correct runs with other samples, compared with it: ${runs}.`,
      neverRight: (samplings: string): string => `Not right under any kernel: ${samplings}.`,
    },
  },
};
