/// Which mistake a program makes: a deviation of the one table (choice/deviation.h) whose own runs do the same.
#pragma once

#include "grade/judge.h"

namespace vidno {

/// What a program did on a scene.
struct Observation {
    const TraceHeader* header;
    const std::vector<Event>* events;
    const Judgement* judgement;
    bool complete;  // the run came to its end
};

/// The deviation that makes the program's false claims and paints its wrong pixels. Its runs are judged by the events that the program
/// tells. They must agree on each scene; where centres of pixels lie on outlines rounding may tell them apart, and such scenes are
/// asked only if there are no others on which the program is wrong, and then two of three must agree.
std::optional<Deviation> deviation_of(const std::vector<Observation>& observed, Precision precision);

/// What it does, and what to tell the student.
std::string in_words(Deviation deviation, const Words& say);

}  // namespace vidno
