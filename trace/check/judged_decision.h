/// JudgedDecision: a verdict with copies of the numbers on which the decision was taken.
#pragma once

#include "format/verdict.h"

namespace vidno {

struct JudgedDecision : Verdict {
    Operands operands{};

    explicit JudgedDecision(const Verdict& verdict, bool with_operands = true) : Verdict(verdict) {
        if (with_operands && calculator) operands = calculator->operands();
        calculator = nullptr;
    }
};

}  // namespace vidno
