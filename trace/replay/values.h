/// The values of a state as JSON: everything except the cells of its screen.
#pragma once

#include "format/field_writer.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"

namespace vidno {

/// Writes the values of states, each either in full or by how it differs from the one before.
class ValuesText {
public:
    explicit ValuesText(PolygonNames names) : names_(std::move(names)) {}

    /// Appends `{"step":N,"calls":[...],...}`. If `before` is given, fields that are the same in both are left out, and
    /// a list is written as `{"from":N,"rest":[...]}`: how many items stay, and those that follow.
    void append(Text& out, const State& state, const State::Values* before = nullptr);
    void append(Text& out, const FloatingHorizonState& state, const FloatingHorizonState::Values* before = nullptr);

private:
    PolygonNames names_;
    RememberedShortest shortest_;
};

}  // namespace vidno
