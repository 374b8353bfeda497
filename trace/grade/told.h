/// ClaimsTold: how many claims of each kind a trace makes. What a trace does not tell is not judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "format/event.h"
#include "format/trace_writer.h"
#include "grade/words.h"

namespace vidno {

/// A kind of claim that traces of a method make, from a level on. A trace of that level must have the `needed` kinds. The others, such as
/// lists of edges, belong to one way of writing the procedure.
struct ClaimKind {
    Bilingual name;  // several of them
    std::string_view method;
    Detail from;
    bool needed;
    std::vector<std::string_view> events;
};

/// How many claims of each kind of the method.
struct ClaimsTold {
    std::vector<std::pair<const ClaimKind*, std::size_t>> counts;

    ClaimsTold& operator+=(const ClaimsTold& other);
};

ClaimsTold told_by(std::string_view method, const std::vector<Event>& events);

/// "12 windows, 30 fills; 0 depths, 0 surround tests".
std::string in_words(const ClaimsTold& told, const Words& say);

/// What of the level is missing, by name; empty if nothing is.
std::string missing_from(const ClaimsTold& told, Detail level, const Words& say);

}  // namespace vidno
