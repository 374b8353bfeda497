/// The exact zeros that the list of decisions has for a scene, for tests that count them independently.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "run/run.h"
#include "support/checked.h"
#include "support/outlines.h"
#include "support/scenes.h"
#include "vidno/admission.h"
#include "vidno/kernels/exact.h"

namespace vidno::test {

/// Hears the events of a run of level `signs`, with their steps.
inline void hear_run(const AdmittedScene& scene, Method method,
                     const std::function<void(std::uint64_t step, const EventView& event)>& hear) {
    std::uint64_t step = 0;
    FunctionSink sink([&](const EventView& event) { hear(++step, event); });
    run(RunRequest{method, *kernel_named("filtered"), Edition::corrected, scene, Detail::signs, &sink});
}

/// The fields of an exact zero that tests compare.
struct Zero {
    std::uint64_t step;
    Line at;
    Procedure procedure;
    Coincidence coincidence;
    std::vector<PolygonPlace> polygons;
    PixelRectangle pixels;

    bool is(Procedure own_procedure, Coincidence own_coincidence) const {
        return procedure == own_procedure && coincidence == own_coincidence;
    }
};

struct JudgedScene {
    AdmittedScene scene;
    std::vector<Zero> zeros;

    /// The steps of those zeros.
    std::set<std::uint64_t> steps(Procedure procedure, Coincidence coincidence) const {
        std::set<std::uint64_t> found;
        for (const auto& zero : zeros) {
            if (zero.is(procedure, coincidence)) found.insert(zero.step);
        }
        return found;
    }
};

/// The zeros of a scene under `filtered`.
inline JudgedScene judged_scene(AdmittedScene scene, Method method) {
    JudgedScene judged{std::move(scene), {}};
    for (const auto& each : of_kind(checked(judged.scene, method, "filtered", 0), FindingKind::zero)) {
        judged.zeros.push_back({each.step, each.at, each.procedure, each.gap->if_zero, each.polygons, each.pixels});
    }
    return judged;
}

/// The exact value of an operand of a finding.
inline Rational exact_operand(const Finding& finding, const std::string& name) {
    for (const auto& operand : finding.decision.operands) {
        if (operand.name != name) continue;
        const auto& text = operand.exact.text;
        const auto slash = text.find('/');
        return Rational(text.substr(0, slash)) / Rational(text.substr(slash + 1));
    }
    FAIL("no operand " << name);
    return 0;
}

inline bool has_operand(const Finding& finding, const std::string& name) {
    const auto& operands = finding.decision.operands;
    return std::any_of(operands.begin(), operands.end(), [&](const Operand& each) { return each.name == name; });
}

/// An operand of a finding that is a line.
inline LineThrough line_operand(const Finding& finding, const std::string& name) {
    const Rational a = exact_operand(finding, name + ".a"), b = exact_operand(finding, name + ".b");
    return line(a, b, a * exact_operand(finding, name + ".x") + b * exact_operand(finding, name + ".y"));
}

/// The operands of a finding on which side of a line a point lies.
inline PointOnLine point_on_line_of(const Finding& finding) {
    return {{exact_operand(finding, "p.x"), exact_operand(finding, "p.y")}, line_operand(finding, "line")};
}

/// In every other scene a polygon is there twice.
inline AdmittedScene scene_with_copies(RandomScenes& random, int number) {
    Scene scene = random.scene();
    if (number % 2 == 1) {
        scene.polygons.push_back(scene.polygons[std::size_t(random.whole(0, int(scene.polygons.size()) - 1))]);
        scene.polygons.back().id = "copy";
    }
    return admit(std::move(scene));
}

}  // namespace vidno::test
