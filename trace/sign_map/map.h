/// SignMap: the decision of a kernel at each place of p, beside the right answer.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "run/run.h"
#include "sign_map/mapped_decision.h"
#include "vidno/picture.h"

namespace vidno {

struct SignMap {
    struct Cell {
        Sign computed, exact;

        bool differs() const { return computed != exact; }
    };
    using Counts = std::array<std::array<int, 3>, 3>;

    std::string name;  // of the decision
    std::string_view decision;
    AnswerNames answers;
    std::string kernel;
    int side;                 // the number of places in a row, and of rows
    std::vector<Cell> cells;  // the row of p first

    const Cell& at(int x, int y) const { return cells[std::size_t(y) * side + std::size_t(x)]; }

    /// The number of cells for each pair of answers: the first index is the computed answer, the second the exact one.
    Counts counts() const;
    int differing() const;
};

/// The signs at the places 0 <= i, j < side <= MappedDecision::side. The decision is taken as in the corrected
/// procedures.
SignMap sign_map(const MappedDecision& decision, const NamedKernel& kernel, int side = MappedDecision::side);

/// The hue shows the computed answer; it is dark where it differs from the exact one.
Color color_of(const SignMap::Cell& cell);

/// The map in the colours of its cells, with p at the lower left, as in the published maps. Black and white pixels side
/// by side mark the border where the exact answer changes.
Picture picture_of(const SignMap& map);

std::string map_json(const SignMap& map);

}  // namespace vidno
