/// ClaimCounts: how many claims of each kind a trace makes. The judge does not check claims that a trace leaves out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "format/event.h"
#include "format/trace_writer.h"
#include "grade/words.h"

namespace vidno {

/// A kind of claim that traces of a method make from a level on. Traces of that level must have the `needed` kinds. The
/// others, such as lists of edges, belong to one way to write the procedure.
struct ClaimKind {
    Bilingual name;  // in the plural
    std::string_view method;
    Detail from;
    bool needed;
    std::vector<std::string_view> events;
};

/// The number of claims of each kind of the method.
struct ClaimCounts {
    std::vector<std::pair<const ClaimKind*, std::size_t>> counts;

    ClaimCounts& operator+=(const ClaimCounts& other);
};

/// Counts the claims that the events of a trace of the method make.
ClaimCounts claim_counts(std::string_view method, const std::vector<Event>& events);

/// "12 windows, 30 fills; 0 depths, 0 surround tests".
std::string in_words(const ClaimCounts& claims, const Words& say);

/// The names of the needed kinds of the level that are missing; empty if none is.
std::string missing_from(const ClaimCounts& claims, Detail level, const Words& say);

}  // namespace vidno
