#include "grade/mistakes.h"

#include <algorithm>
#include <vector>

#include "run/run.h"

namespace vidno {

namespace {

bool paints_right(const Observation& observed) {
    const SceneTruth truth(observed.header->scene, Precision::single);
    const Area& area = observed.header->scene.area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            if (!truth.allows(column, row, observed.judgement->picture.at(column, row))) return false;
        }
    }
    return true;
}

bool paints_as(const Observation& observed, Edition edition) {
    const TraceHeader& header = *observed.header;
    const NamedKernel kernel = *kernel_named("double");
    return kernel.choice->runs(header.method, edition) &&
           run({header.method, kernel, edition, header.scene}) == observed.judgement->picture;
}

/// The mistake that is counted most often, if that is on two scenes of three.
std::optional<Edition> most_frequent(std::size_t scenes, auto&& count) {
    std::optional<Edition> best;
    std::ptrdiff_t most = 0;
    for (const auto& [edition, name, rule, title] : named_editions) {
        if (!is_mistake(edition)) continue;
        const std::ptrdiff_t counted = count(edition);
        if (counted <= most || 3 * std::size_t(counted) < 2 * scenes) continue;
        most = counted;
        best = edition;
    }
    return best;
}

/// By the pictures that are wrong.
std::optional<Edition> by_pictures(const std::vector<Observation>& observed) {
    std::vector<const Observation*> wrong;
    for (const auto& each : observed) {
        if (each.complete && each.judgement->wrong && !paints_right(each)) wrong.push_back(&each);
    }
    return most_frequent(wrong.size(), [&](Edition mistake) {
        return std::count_if(wrong.begin(), wrong.end(), [&](const auto* each) { return paints_as(*each, mistake); });
    });
}

std::optional<Edition> mistake_of(Symptom symptom) {
    switch (symptom) {
        case Symptom::overlooked: return Deviation::one_list;
        case Symptom::start: return Deviation::depths_not_cleared;
        case Symptom::clipped_away:
        case Symptom::clipped_inside: return Deviation::clip_order_reversed;
        case Symptom::off_window: return Deviation::y_flipped;
        case Symptom::comparison: return Deviation::depth_sign_reversed;
        case Symptom::hole: return Deviation::boundary_outside;
        case Symptom::parts_missing: return Deviation::integer_division;
        case Symptom::surrounded: return Deviation::surround_kept;
        default: return std::nullopt;
    }
}

/// By the kinds of steps that are wrong.
std::optional<Edition> by_steps(const std::vector<Observation>& observed) {
    std::vector<Symptom> symptoms;
    for (const auto& each : observed) {
        if (each.judgement->wrong) symptoms.push_back(each.judgement->wrong->symptom);
    }
    return most_frequent(symptoms.size(), [&](Edition mistake) {
        return std::count_if(symptoms.begin(), symptoms.end(),
                             [&](Symptom each) { return mistake_of(each) == mistake; });
    });
}

}  // namespace

std::optional<Edition> usual_mistake(const std::vector<Observation>& observed) {
    const auto mistake = by_pictures(observed);
    return mistake ? mistake : by_steps(observed);
}

}  // namespace vidno
