#include "sign_map/failed_decision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/seen_failure.h"
#include "refused.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

/// The distance from a double to the next one away from 0, at least the distance near 1.
double spacing_at(double coordinate) {
    const double size = std::max(std::abs(coordinate), 1.0);
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

}  // namespace

MappedDecision failed_decision(const Failure& failure, const std::string& file) {
    const SeenFailure found = seen(failure);
    const auto* orient = found.event ? found.event->get_if<event::Orient>() : nullptr;
    constexpr const char* refusal =
        ": a map shows on which side of an edge a point lies, and this is another failure: ";
    if (!orient) throw Refused(file + refusal + found.there.english);

    const auto& vertices =
        std::get<AdmittedScene>(*failure.scene)->polygons[std::size_t(orient->polygon.index)].vertices;
    const auto from = std::size_t(orient->edge);
    const glm::dvec2 point{orient->point.x.number, orient->point.y.number};
    MappedDecision decision{failure.title.english, {}, std::max(spacing_at(point.x), spacing_at(point.y)), {}};
    const auto are_doubles = [&](double start) {
        return exact_scene::are_doubles(start, decision.step, MappedDecision::side);
    };
    constexpr int before_middle = MappedDecision::side / 2;
    do {
        decision.p = point - glm::dvec2(before_middle) * decision.step;
    } while (!(are_doubles(decision.p.x) && are_doubles(decision.p.y)) && (decision.step *= 2) < 1);
    constexpr int pivot = 1;  // as in SurroundTest: the beginning of the edge
    decision.asked = MappedOrientation{vertices[from], vertices[(from + 1) % vertices.size()], pivot};
    return decision;
}

}  // namespace vidno
