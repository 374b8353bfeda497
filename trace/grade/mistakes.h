/// Which usual mistake a program makes.
#pragma once

#include "grade/judge.h"

namespace vidno {

/// What a program did on a scene.
struct Observation {
    const TraceHeader* header;
    const Judgement* judgement;
    bool complete;  // the run came to its end
};

/// The edition whose runs of the same scenes paint the same pictures; else the one that goes wrong at the same kind of step on
/// most of the scenes on which the program is wrong. None if it is no usual mistake.
std::optional<Edition> usual_mistake(const std::vector<Observation>& observed);

}  // namespace vidno
