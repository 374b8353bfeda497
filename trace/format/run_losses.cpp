#include "format/run_losses.h"

#include <algorithm>
#include <cmath>

#include "choice/kernel_choice.h"
#include "counted.h"

namespace vidno {

namespace {

constexpr std::size_t most_listed = 20;

bool is_of_outline(const event::Fault& fault) {
    using enum Line;
    return fault.at == RC4 || fault.at == RC5 || fault.at == SP3;
}

/// Faults of SurroundTest and of the Z-buffer concern the polygon at hand.
bool is_of_one_polygon(Line at) {
    using enum Line;
    return at == S2 || at == Z14 || at == Z15 || at == L3 || at == L6 || at == L7;
}

bool is_finite(const Value& value) { return value.fraction || std::isfinite(value.number); }

bool is_finite(const RegionLoops& region) {
    const auto is_point = [](const ValuePoint& point) { return is_finite(point.x) && is_finite(point.y); };
    return std::all_of(region.begin(), region.end(),
                       [&](const auto& loop) { return std::all_of(loop.begin(), loop.end(), is_point); });
}

std::string consequence_of(const event::Fault& fault) {
    if (fault.x) return ", so the write is skipped";
    return ends_run(fault) ? ", so the run ends here" : ", so a part is left out";
}

}  // namespace

bool ends_run(const event::Fault& fault) { return !fault.x && !is_of_outline(fault); }

RunLosses::RunLosses(std::string_view kernel) : is_always_right_(is_always_right(kernel)) {}

void RunLosses::add(Found found) {
    if (found_.size() < most_listed) {
        found_.push_back(std::move(found));
    } else {
        ++more_;
    }
}

void RunLosses::hear(const event::Fault& fault) {
    using enum Line;
    Found found{steps_, fault.at, fault.reason + consequence_of(fault), {}, {}};
    if (is_of_one_polygon(fault.at)) found.polygons = at_hand_;
    if (fault.x) found.elsewhere = "pixel (" + std::to_string(*fault.x) + ", " + std::to_string(*fault.y) + ")";
    if (fault.at == SP3) found.polygons = pierced_;
    add(std::move(found));
    if (fault.at != RC4 && fault.at != RC5) settled_ = found_.size();
}

void RunLosses::settle(PolygonPlace polygon) {
    for (; settled_ < found_.size(); ++settled_) found_[settled_].polygons = {polygon};
}

void RunLosses::hear(const EventView& event) {
    ++steps_;
    if (const auto* fault = event.get_if<event::Fault>()) hear(*fault);
    if (const auto* polygon = event.get_if<event::Polygon>()) at_hand_ = {polygon->polygon};
    if (const auto* orient = event.get_if<event::Orient>()) at_hand_ = {orient->polygon};
    if (const auto* pierce = event.get_if<event::Pierce>()) pierced_ = {pierce->polygon, pierce->other};
    if (const auto* cut = event.get_if<event::CutToArea>()) settle(cut->polygon);
    if (const auto* clipped = event.get_if<event::Clipped>()) settle(clipped->polygon);
    if (const auto* curve = event.get_if<event::Curve>()) curve_ = curve->curve;
    if (is_always_right_) return;
    if (const auto* plane = event.get_if<event::Plane>()) {
        for (const Value& number : plane->plane) {
            if (is_finite(number)) continue;
            add({steps_,
                 plane->at,
                 "its plane leaves the range of the numbers, so no pixel of it is decided",
                 {plane->polygon},
                 {}});
            settled_ = found_.size();
            break;
        }
    }
    if (const auto* shown = event.get_if<event::Show>(); shown && !is_finite(shown->region)) {
        add({steps_,
             shown->at,
             "a corner of its region leaves the range of the numbers, so a part is not decided",
             {shown->polygon},
             {}});
        settled_ = found_.size();
    }
    if (const auto* line = event.get_if<event::DrawLine>()) {
        if (is_finite(line->from.x) && is_finite(line->from.y) && is_finite(line->to.x) && is_finite(line->to.y))
            return;
        add({steps_,
             line->at,
             "an end of its line leaves the range of the numbers",
             {},
             "curve " + std::to_string(curve_)});
    }
}

std::vector<Loss> RunLosses::all(const PolygonNames& names) const {
    std::vector<Loss> losses;
    for (const auto& [step, at, what, polygons, elsewhere] : found_) {
        std::string where = "step " + std::to_string(step) + ", " + std::string(line_names[std::size_t(at)]);
        std::string before = polygons.size() > 1 ? ", polygons " : ", polygon ";
        for (const PolygonPlace polygon : polygons) {
            where += before + names.at(std::size_t(polygon.index));
            before = " and ";
        }
        if (!elsewhere.empty()) where += ", " + elsewhere;
        losses.push_back({what, where});
    }
    if (more_ > 0) losses.push_back({counted(more_, "more loss", "more losses") + " of this run", {}});
    return losses;
}

}  // namespace vidno
