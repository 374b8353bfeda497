#include "sign_map/map.h"

#include <algorithm>
#include <cassert>

#include "run/run_time_kernel.h"
#include "vidno/corrected.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

namespace {

/// The scene that a kernel sees: the polygons of the decision, and one that reaches as far as everything else.
Scene scene_of(const MappedDecision& decision, int side) {
    Scene scene;
    scene.area = {0, 0, 1, 1};
    std::vector<glm::dvec3> reach;
    const auto reaches = [&](const glm::dvec2& v) { reach.emplace_back(v, 0); };
    const int last = side - 1;
    for (const auto& corner : {decision.p, decision.place(last, 0), decision.place(last, last)}) reaches(corner);
    std::visit(
        [&]<class Asked>(const Asked& asked) {
            if constexpr (requires { asked.q; }) reaches(asked.q);
            if constexpr (requires { asked.r; }) reaches(asked.r);
            if constexpr (requires { asked.window; }) scene.area = asked.window;
            if constexpr (requires { asked.polygon; }) scene.polygons = {asked.polygon};
            if constexpr (requires { asked.polygons; }) scene.polygons = {asked.polygons[0], asked.polygons[1]};
        },
        decision.asked);
    scene.polygons.push_back({"", {}, reach});
    return scene;
}

Sign sign_of(bool answer) { return answer ? Sign::positive : Sign::negative; }

Sign decide(const MappedOrientation& asked, auto& run, const glm::dvec2& p) {
    const auto point = [&](const glm::dvec2& v) { return run.kernel.point(v.x, v.y); };
    std::array points{point(p), point(asked.q), point(asked.r)};
    std::rotate(points.begin(), points.begin() + asked.pivot, points.end());
    return run.kernel.sign(run.kernel.cross(points[0], points[1], points[2]));
}

Sign decide(const MappedSurround&, auto& run, const glm::dvec2& p) {
    return sign_of(Corrected::surround_test(run, run.kernel.point(p.x, p.y), run.polygons.front()));
}

Sign decide(const MappedClip& asked, auto& run, const glm::dvec2& p) {
    const auto& kernel = run.kernel;
    const auto [lb, lt, rb, rt] = corners_of(kernel, whole_area(asked.window));
    const std::array corners{lb, lt, rt, rb};  // F_1 to F_4
    const auto cross = [&](int side, const auto& vertex) {
        return kernel.cross(corners[side - 1], vertex, corners[(side + 2) % 4]);
    };
    const std::vector edge{kernel.vertex({p, 0}), kernel.vertex({asked.q, 0})};
    const auto ends = kernel.outline(edge);
    const auto found = kernel.meet(ends[0], ends[1], cross(asked.cut, ends[0]), cross(asked.cut, ends[1]));
    return kernel.sign(cross(asked.side, found));
}

Sign decide(const MappedDepth&, auto& run, const glm::dvec2& p) {
    const auto point = run.kernel.point(p.x, p.y);
    const auto depth = [&](std::size_t i) { return Corrected::depth(run, run.polygons[i], point); };
    return sign_of(run.kernel.nearer(depth(0), depth(1), point));
}

template <Kernel K>
std::vector<Sign> answers_under(const K& kernel, const MappedDecision& decision, int side) {
    const Scene scene = scene_of(decision, side);
    Picture unused({0, 0, 1, 1}, {});
    Run<Corrected, K, NoTrace> run(scene, kernel, {}, unused);
    std::vector<Sign> answers;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto answer = [&](const auto& asked) { return decide(asked, run, decision.place(x, y)); };
            answers.push_back(std::visit(answer, decision.asked));
        }
    }
    return answers;
}

}  // namespace

SignMap::Counts SignMap::counts() const {
    Counts counts{};
    for (const auto& [computed, exact] : cells) ++counts[place_of(computed)][place_of(exact)];
    return counts;
}

int SignMap::differing() const {
    return int(std::count_if(cells.begin(), cells.end(), [](const Cell& cell) { return cell.differs(); }));
}

SignMap sign_map(const MappedDecision& decision, const NamedKernel& named, int side) {
    assert(0 < side && side <= MappedDecision::side);
    SignMap map = std::visit(
        [&](const auto& asked) {
            return SignMap{decision.name, asked.decision, asked.answers, named.name(), side, {}};
        },
        decision.asked);
    const auto exact = answers_under(RunTimeKernel(kernel_of(KernelKind::exact), {}), decision, side);
    const auto computed = named.kind() == KernelKind::filtered
                              ? answers_under(Filtered{}, decision, side)
                              : answers_under(RunTimeKernel(named, {}), decision, side);
    for (std::size_t i = 0; i < exact.size(); ++i) map.cells.push_back({computed[i], exact[i]});
    return map;
}

}  // namespace vidno
