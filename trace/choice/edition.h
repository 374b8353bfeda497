/// Edition: the text of the procedures that runs: the corrected one with a set of deviations.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "choice/deviation.h"

namespace vidno {

/// Corrected, as printed (with all defects of the text), with one usual mistake, or with some of the defects.
class Edition {
public:
    constexpr Edition() = default;
    constexpr Edition(Deviation deviation) : bits_(Bits{1} << unsigned(deviation)) {}

    constexpr bool has(Edition all) const { return (bits_ & all.bits_) == all.bits_; }
    friend constexpr Edition operator+(Edition one, Edition other) { return Edition(one.bits_ | other.bits_); }
    constexpr auto operator<=>(const Edition&) const = default;

    static const Edition corrected, printed;

private:
    using Bits = std::uint64_t;
    static_assert(deviations.size() <= std::numeric_limits<Bits>::digits);

    explicit constexpr Edition(Bits bits) : bits_(bits) {}

    Bits bits_ = 0;
};

inline constexpr Edition Edition::corrected{};
inline constexpr Edition Edition::printed = [] {
    Edition all;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (!deviations[i].defect.empty()) all = all + Edition(Deviation(i));
    }
    return all;
}();

/// The deviation that an edition consists of, if it is a single one.
constexpr std::optional<Deviation> single_deviation(Edition edition) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (edition == Edition(Deviation(i))) return Deviation(i);
    }
    return std::nullopt;
}

constexpr bool is_mistake(Edition edition) {
    const auto single = single_deviation(edition);
    return single && !choice_of(*single).mistake.empty();
}

/// An edition with a name of its own: corrected, printed, or a usual mistake.
struct NamedEdition {
    Edition edition;
    std::string_view name, rule;
    Bilingual title;  // on the page; for a mistake, its description
};

inline constexpr auto named_editions = [] {
    constexpr auto mistakes = std::count_if(deviations.begin(), deviations.end(),
                                            [](const DeviationChoice& each) { return !each.mistake.empty(); });
    std::array<NamedEdition, 2 + mistakes> named{
        NamedEdition{Edition::corrected,
                     "corrected",
                     "the procedures with the errors of the printed text corrected",
                     {"corrected", "исправленный текст"}},
        NamedEdition{Edition::printed,
                     "printed",
                     "as the course text prints them, errors included",
                     {"as printed", "как напечатано"}},
    };
    std::size_t count = 2;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const auto& each = deviations[i];
        if (!each.mistake.empty()) named[count++] = {Deviation(i), each.mistake, each.says.english, each.title};
    }
    return named;
}();

/// The prefix of names of single defects: "printed:x-w2+x-w4".
inline constexpr std::string_view single_defects = "printed:";

/// The defect of the printed text with this id.
inline std::optional<Deviation> defect_named(std::string_view id) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (!id.empty() && deviations[i].defect == id) return Deviation(i);
    }
    return std::nullopt;
}

inline std::string name_of(Edition edition) {
    for (const auto& named : named_editions) {
        if (named.edition == edition) return std::string(named.name);
    }
    std::string defects;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (edition.has(Deviation(i))) (defects += defects.empty() ? single_defects : "+") += deviations[i].defect;
    }
    return defects;
}

/// None if no edition has the name. Single defects may be named in any order.
inline std::optional<Edition> edition_named(std::string_view name) {
    for (const auto& named : named_editions) {
        if (named.name == name) return named.edition;
    }
    if (!name.starts_with(single_defects)) return std::nullopt;
    Edition edition;
    for (auto rest = name.substr(single_defects.size());;) {
        const auto end = std::min(rest.find('+'), rest.size());
        const auto defect = defect_named(rest.substr(0, end));
        if (!defect) return std::nullopt;
        edition = edition + *defect;
        if (end == rest.size()) return edition;
        rest.remove_prefix(end + 1);
    }
}

/// Whether a method has such a text; `concerns(choice)` says whether a deviation concerns the method.
constexpr bool has_text(Edition edition, auto&& concerns) {
    if (edition == Edition::corrected) return true;
    bool any = false, all = true;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        if (!edition.has(Deviation(i))) continue;
        (concerns(deviations[i]) ? any = true : all = false);
    }
    return any && (all || edition == Edition::printed);
}
constexpr bool has_text(Edition edition, Method method) {
    return has_text(edition, [method](const DeviationChoice& each) {
        return std::find(each.methods.begin(), each.methods.end(), method) != each.methods.end();
    });
}
constexpr bool has_text_of_curves(Edition edition) {
    return has_text(edition, [](const DeviationChoice& each) { return each.methods.empty(); });
}

}  // namespace vidno
