#include "grade/claim_counts.h"

#include <algorithm>

namespace vidno {

namespace {

const std::vector<ClaimKind>& claim_kinds() {
    using enum Detail;
    static const std::vector<ClaimKind> kinds{
        {{"windows", "окон"}, "warnock", windows, true, {"decide"}},
        {{"fills", "закрашиваний"}, "warnock", windows, true, {"fill", "draw"}},
        {{"polygons in lists", "многоугольников в списках"}, "warnock", polygons, false, {"count", "discard", "mark"}},
        {{"depths", "глубин"}, "warnock", polygons, true, {"depth"}},
        {{"surround tests", "проверок принадлежности"}, "warnock", polygons, true, {"surround"}},
        {{"clipped polygons", "отсечённых многоугольников"}, "warnock", polygons, false, {"clip_result"}},
        {{"comparisons of depths", "сравнений глубин"}, "warnock", signs, true, {"compare"}},
        {{"signs", "знаков"}, "warnock", signs, true, {"orient", "clip_sign"}},
        {{"polygons", "многоугольников"}, "zbuffer", windows, true, {"polygon"}},
        {{"spans", "отрезков"}, "zbuffer", windows, true, {"span"}},
        {{"active edges", "активных рёбер"}, "zbuffer", polygons, false, {"ael_add", "ael_step", "line"}},
        {{"depths", "глубин"}, "zbuffer", polygons, true, {"pixel", "depth"}},
        {{"comparisons of depths", "сравнений глубин"}, "zbuffer", signs, true, {"pixel"}},
        {{"visible regions", "видимых областей"}, "weiler-atherton", windows, true, {"show"}},
        {{"lists", "списков"}, "weiler-atherton", windows, false, {"push_list"}},
        {{"painted runs", "закрашиваний"}, "weiler-atherton", windows, false, {"paint"}},
        {{"clipped pieces", "отсечённых частей"}, "weiler-atherton", polygons, true, {"clipped", "cut_to_area"}},
        {{"depths", "глубин"}, "weiler-atherton", polygons, true, {"behind", "depth"}},
        {{"curves", "кривых"}, "floating-horizon", windows, true, {"curve"}},
        {{"lines", "линий"}, "floating-horizon", windows, true, {"draw_line"}},
        {{"side edges", "боковых рёбер"}, "floating-horizon", polygons, false, {"side_edge"}},
        {{"flags", "флагов"}, "floating-horizon", polygons, true, {"visibility"}},
        {{"intersections", "пересечений"}, "floating-horizon", polygons, false, {"intersection"}},
        {{"changed horizons", "изменений горизонтов"},
         "floating-horizon",
         polygons,
         true,
         {"horizon", "raise", "lower"}},
        {{"heights", "высот"}, "floating-horizon", signs, true, {"height"}},
    };
    return kinds;
}

std::string_view name_of(const EventView& event) { return event_names[event.place()]; }

}  // namespace

ClaimCounts& ClaimCounts::operator+=(const ClaimCounts& other) {
    if (counts.empty())
        counts = other.counts;
    else
        for (std::size_t i = 0; i < std::min(counts.size(), other.counts.size()); ++i)
            counts[i].second += other.counts[i].second;
    return *this;
}

ClaimCounts claim_counts(std::string_view method, const std::vector<Event>& events) {
    ClaimCounts claims;
    for (const ClaimKind& kind : claim_kinds()) {
        if (kind.method != method) continue;
        const auto makes_it = [&](const EventView& event) {
            return std::find(kind.events.begin(), kind.events.end(), name_of(event)) != kind.events.end();
        };
        claims.counts.emplace_back(&kind, std::size_t(std::count_if(events.begin(), events.end(), makes_it)));
    }
    return claims;
}

std::string in_words(const ClaimCounts& claims, const Words& say) {
    std::string there, missing;
    for (const auto& [kind, count] : claims.counts) {
        std::string& list = count > 0 ? there : missing;
        if (!list.empty()) list += ", ";
        list += say({"{0} {1}", "{1}: {0}"}, count, say.of(kind->name));
    }
    return there + (there.empty() || missing.empty() ? "" : "; ") + missing;
}

std::string missing_from(const ClaimCounts& claims, Detail level, const Words& say) {
    std::string missing;
    for (const auto& [kind, count] : claims.counts) {
        if (!kind->needed || kind->from > level || count > 0) continue;
        if (!missing.empty()) missing += ", ";
        missing += say.of(kind->name);
    }
    return missing;
}

}  // namespace vidno
