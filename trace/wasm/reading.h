/// Reading: reads a trace block by block, for a page.
#pragma once

#include <memory>
#include <string_view>

#include "format/trace_writer.h"

namespace vidno {

class Reading {
public:
    /// Begins with the first line. Throws Refused.
    explicit Reading(std::string_view first_line);
    ~Reading();

    /// Adds the next lines, each with its line feed, up to the first that is not an event in the form that a run writes, or that cannot
    /// happen.
    void take(std::string_view text, LineIndex& lines);

private:
    struct Run;
    template <class State, class Header>
    struct RunOf;

    std::unique_ptr<Run> run_;
};

}  // namespace vidno
