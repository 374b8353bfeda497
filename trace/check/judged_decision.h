/// JudgedDecision: a verdict with the numbers that the decision was taken on, to be kept.
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
