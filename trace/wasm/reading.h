/// Reading: a trace as a page reads it, block by block.
#pragma once

#include <memory>
#include <string_view>

#include "format/trace_writer.h"

namespace vidno {

class Reading {
public:
    /// By the first line. Throws Refused.
    explicit Reading(std::string_view first_line);
    ~Reading();

    /// Adds the next lines, each with its line feed, up to the first that is not an event as a run writes it, or one that cannot happen.
    void take(std::string_view text, LineIndex& lines);

private:
    struct Run;
    template <class State, class Header>
    struct RunOf;

    std::unique_ptr<Run> run_;
};

}  // namespace vidno
