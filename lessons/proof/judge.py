"""The judge of a trace: it hears the events, redoes each decision, and counts what is proved."""

import collections
import math
from fractions import Fraction

import answers
from chain import Contradiction, NotTold, expect
from chain_floating_horizon import FloatingHorizonChain
from chain_warnock import WarnockChain
from chain_weiler_atherton import WeilerAthertonChain
from chain_z_buffer import ZBufferChain
from kernel import Kernel, parsed

# The kind of the decision that an event reports, and the fields of its answer.
REPORTED = {
    "box": ("outside", "outside"), "compare": ("nearer", "nearer"), "insider": ("inside", "inside"),
    "orient": ("orientation", "sign"), "clip_sign": ("orientation", "sign"), "row": ("columns", "first", "end"),
    "columns": ("columns", "first", "end"), "pixel": ("nearer", "shown"), "visibility": ("visibility", "flag"),
    "behind": ("comparison", "order"), "order": ("comparison", "order"),
}  # fmt: skip
CHAINS = {"zbuffer": ZBufferChain, "weiler-atherton": WeilerAthertonChain, "floating-horizon": FloatingHorizonChain}
WHOLE = ("low", "end", "row")
NO_OPERANDS = "the edition or the kernel leaves out its operands"


def is_number(name, value):
    """Does a decision have an exact answer for this operand? No depth yet is minus infinity, and farther than every number."""
    return isinstance(value, Fraction) or (name == "against" and value == -math.inf)


class Judge:
    def __init__(self, header):
        self.kernel = Kernel(header["kernel"])
        self.chain = CHAINS.get(header["method"], WarnockChain)(header, self.kernel)
        self.flag_on_both = 1 if self.chain.has("x-h6") else 2
        self.counts = collections.defaultdict(collections.Counter)  # by the kind of the decision and its line
        self.reasons = collections.Counter()
        self.first_drifts = {}
        self.reported, self.owes = None, False

    # The answer

    def answer(self, of, numbers, number, relation):
        try:
            return answers.answer(of, numbers, number, relation, self.flag_on_both)
        except ZeroDivisionError:
            return False if of == "parallel" else None

    def answers(self, of, operands, taken, exact):
        """The run's answer; the exact one; and the exact one for the numbers in use, if they are numbers."""
        in_use = {name: parsed(used) for name, used, _ in operands}
        right = {name: parsed(text) for name, _, text in operands}
        by_run = {name: int(value) if name in WHOLE else self.kernel.number(value) for name, value in in_use.items()}
        for relation in answers.RELATIONS if of == "comparison" and isinstance(taken, bool) else [None]:
            found = [self.answer(of, by_run, self.kernel.number, relation)]
            for numbers in (right, in_use):
                has_answer = all(is_number(name, value) for name, value in numbers.items())
                found.append(self.answer(of, numbers, Fraction, relation) if has_answer else None)
            if found[:2] == [taken, exact]:
                break
        return found

    def expect_answer(self, of, taken, exact, operands, cause=None):
        by_run, right, for_numbers = self.answers(of, operands, taken, exact)
        expect(by_run == taken, f"the run's operands give {by_run}, not {taken}")
        expect(right == exact, f"the exact operands give {right}, not {exact}")
        if cause:
            because = "drifted" if for_numbers in (None, taken) else "rounded"
            expect(cause == because, f"the answer is wrong because it {because}, not because it {cause}")

    def expect_value(self, event):
        """The cross product, in the run's numbers."""
        used = {name: self.kernel.number(parsed(used)) for name, used, _ in event["operands"]}
        pivot, a, b = [(used[name + ".x"], used[name + ".y"]) for name in ("pivot", "a", "b")]
        value = answers.turn(pivot, a, b)
        is_told = self.kernel.tells(event["value"], self.kernel.in_use(value))
        expect(is_told, f"the value is {getattr(value, 'value', value)}, not {event['value']}")

    # The operands

    def expect_operands(self, of, operands, candidates):
        """They are those of a candidate; without candidates, numbers that the chain knows."""
        if isinstance(candidates, NotTold):
            raise candidates
        if candidates is None:
            return self.chain.expect_known(of, operands)
        reasons = []
        for expected in candidates:
            expect(set(expected) == {name for name, _, _ in operands}, "the operands should be", *sorted(expected))
            differences = ((name, expected[name].difference(used, exact)) for name, used, exact in operands)
            wrong = next((f"{name} is {reason}" for name, reason in differences if reason), None)
            if wrong is None:
                return None
            reasons.append(wrong)
        raise Contradiction(reasons[0] if len(reasons) == 1 else f"none of {len(reasons)} possible operands is the given one")

    def count(self, of, at, is_wrong, operands, candidates):
        counts = self.counts[of, at]
        counts.update(["all", *(["wrong"] if is_wrong else [])])
        try:
            self.expect_operands(of, operands, candidates)
        except NotTold as reason:
            return self.count_not_told(counts, of, at, reason)
        drifted = [each for each in operands if each[1] != each[2] and not self.kernel.is_always_right]
        counts["drifted" if drifted else "proved"] += 1
        if drifted:
            name, used, exact = drifted[0]
            self.first_drifts.setdefault((of, at), f"line {self.line}: {name} is {used}, exactly {exact or 'undefined'}")
        return None

    def count_not_told(self, counts, of, at, reason):
        counts["not told"] += 1
        self.reasons[of, at, str(reason)] += 1

    # Events

    def hear(self, line, event):
        self.line = line
        if event["e"] == "disagree":
            return self.hear_disagree(event)
        self.expect_disagree()
        self.event = event["e"]
        try:
            candidates = self.chain.hear(event)
            candidates = [candidates] if isinstance(candidates, dict) else candidates
        except NotTold as reason:
            candidates = reason
        if event["e"] in REPORTED:
            self.hear_decision(event, candidates)
        return None

    def hear_decision(self, event, candidates):
        of, *fields = REPORTED[event["e"]]
        taken = event[fields[0]] if len(fields) == 1 else [event[field] for field in fields]
        at, operands, exact = event["at"], event.get("operands"), event.get("exact")
        if operands is None:
            return self.hear_bare_decision(of, at, taken, exact, candidates)
        self.reported = of, taken, exact, operands
        self.owes = exact is not None and taken != exact
        self.expect_answer(of, taken, exact, operands)
        if "value" in event:
            self.expect_value(event)
        self.count(of, at, self.owes, operands, candidates)
        return None

    def hear_bare_decision(self, of, at, taken, exact, candidates):
        """A decision without operands: the chain may know how the edition decides, and its operands."""
        counts = self.counts[of, at]
        counts["all"] += 1
        derived = self.chain.answer_of(of, candidates)
        if derived is None:
            return self.count_not_told(counts, of, at, NO_OPERANDS)
        answer, has_drifted = derived
        expect(answer == taken, f"the run's operands give {answer}, not {taken}")
        expect(exact is None or exact == taken, f"the exact operands give {taken}, not {exact}")
        counts["drifted" if has_drifted else "proved"] += 1
        return None

    def hear_disagree(self, event):
        """It repeats a wrong answer of the event before, or tells a wrong decision that no event reports."""
        of, taken, exact, operands = event["of"], event["taken"], event["exact"], event.get("operands")
        expect(taken != exact, "both answers are the same")
        if operands is None:
            self.counts[of, event["at"]].update(["all", "wrong"])
            return self.count_not_told(self.counts[of, event["at"]], of, event["at"], NO_OPERANDS)
        self.expect_answer(of, taken, exact, operands, event["cause"])
        if self.reported == (of, taken, exact, operands) or self.is_end_of_wrong_columns(of):
            self.owes = False
            return None
        try:
            candidates = self.chain.operands_of(event)
        except NotTold as reason:
            candidates = reason
        return self.count(of, event["at"], True, operands, candidates)

    def is_end_of_wrong_columns(self, of):
        """Does the event before tell both ends of a row, of which this is one?"""
        is_wrong = self.reported and self.reported[0] == "columns" and self.reported[1] != self.reported[2]
        return is_wrong and of in ("first_centre", "last_centre")

    def expect_disagree(self):
        owes, self.owes, self.reported = self.owes, False, None
        expect(not owes, "the decision before is wrong, but no `disagree` follows it")
