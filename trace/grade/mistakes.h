/// Mistakes: finds the deviation (choice/deviation.h) whose own runs fail as the program's runs do.
#pragma once

#include "grade/judge.h"

namespace vidno {

/// What a program did on a scene.
struct Observation {
    const AnyHeader* header;
    const std::vector<Event>* events;
    const Judgement* judgement;
    bool complete;  // the run reached its end
};

/// The deviation whose runs are wrong at the program's wrong places and make its first false claim; none if no
/// deviation does. Its runs are judged by the kinds of events that the program reports. If the program is wrong on a
/// plain scene (Judgement::is_plain), only such scenes count and the runs must agree on all of them. Otherwise rounding
/// may separate the runs, so two thirds of the scenes on which the program is wrong must agree.
std::optional<Deviation> deviation_of(const std::vector<Observation>& observed, Precision precision);

/// A sentence for the student: the name of the deviation and the advice on it, or what it does.
std::string in_words(Deviation deviation, const Words& say);

}  // namespace vidno
