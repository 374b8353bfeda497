/// The usual mistakes, and which of them a program makes.
#pragma once

#include "grade/judge.h"

namespace vidno {

enum class UsualMistake : unsigned char {
    one_list,
    depths_not_cleared,
    clip_order_reversed,
    y_flipped,
    depth_sign_reversed,
    boundary_outside,
    integer_division,
    surround_kept
};

/// What went wrong and what to do about it, to the student.
std::string_view words_of(UsualMistake mistake);

/// What a program did on a scene.
struct Observation {
    const Scene* scene;
    const Judgement* judgement;
    bool complete;  // the run came to its end
};

/// The mistake under which the program's pictures are those that it paints; else the one that goes wrong at the same kind of
/// step on most of the scenes on which the program is wrong. None if it is no usual one.
std::optional<UsualMistake> usual_mistake(const std::vector<Observation>& observed);

}  // namespace vidno
