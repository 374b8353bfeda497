#include "check/examiner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "choice/method.h"
#include "format/run_losses.h"
#include "scene/families.h"
#include "vidno/kernels/exact.h"
#include "vidno/vidno.h"

namespace vidno {

/// The depths of a scene's planes, exactly.
class Examiner::Depths {
public:
    explicit Depths(const Scene& scene) : run_(scene, Exact{}, {}, not_painted_) {}

    /// How far off a depth is, in ulps of a double of its size, but no finer than those of 1.
    double ulps_off(std::size_t polygon, double x, double y, double z) const {
        const Polygon<Exact>& of = run_.polygons[polygon];
        if (of.edge_on) return 0;  // it has no depth
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return infinity;
        const Rational right = *run_.kernel.depth(of.plane, Point<Rational>{x, y});
        const double size = std::max(1.0, std::abs(CGAL::to_double(right)));
        const double ulp = std::ldexp(std::numeric_limits<double>::epsilon(), std::ilogb(size));
        return std::abs(CGAL::to_double(Rational(Rational(z) - right))) / ulp;
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Picture not_painted_{{}, {}};
    Run<Corrected, Exact, NoTrace> run_;
};

namespace {

/// The right picture, by `filtered`, since `exact` would take longer.
Picture picture_of(const AdmittedScene& scene) {
    return run({Method::zbuffer, kernel_of(KernelKind::filtered), Edition::corrected, scene});
}

/// The operation that an event reports; most report none.
struct OperationOf {
    using enum Operation;
    using Found = std::optional<Operation>;

    Found operator()(const event::Pop&) const { return windows; }
    Found operator()(const event::Box&) const { return boxes; }
    Found operator()(const event::Insider&) const { return boxes; }
    Found operator()(const event::Depth&) const { return depths; }
    Found operator()(const event::Orient&) const { return orientations; }
    Found operator()(const event::ClipSign&) const { return orientations; }
    Found operator()(const event::Compare&) const { return comparisons; }
    Found operator()(const event::Pixel&) const { return comparisons; }
    Found operator()(const event::ClipCross&) const { return intersections; }
    Found operator()(const event::Row&) const { return rows; }
    Found operator()(const event::ShownLine&) const { return rows; }
    Found operator()(const event::AelAdd&) const { return edges; }
    Found operator()(const event::AelStep&) const { return edges; }
    Found operator()(const event::PopList&) const { return windows; }
    Found operator()(const event::EdgePiece&) const { return orientations; }
    Found operator()(const event::Entering&) const { return intersections; }
    Found operator()(const event::Leaving&) const { return intersections; }
    Found operator()(const event::Beside&) const { return boxes; }
    Found operator()(const event::Behind&) const { return comparisons; }
    Found operator()(const event::Order&) const { return comparisons; }
    Found operator()(const auto&) const { return std::nullopt; }
};

}  // namespace

Examiner::Examiner(const AdmittedScene& scene)
    : scene_(scene), right_(right_picture(scene)), visible_(scene), depths_(std::make_unique<const Depths>(scene)) {}

Examiner::~Examiner() = default;

Findings Examiner::examine(const RunRequest& request, const std::vector<std::size_t>& sources) const {
    Findings found;
    PolygonPlace scanned;
    RunLosses losses(request.kernel.name());
    const auto look_at_depth = [&](PolygonPlace polygon, const Value& x, const Value& y, const Value& z) {
        if (z.fraction) return;  // exact
        const auto source = sources[std::size_t(polygon.index)];
        found.depth_ulps = std::max(found.depth_ulps, depths_->ulps_off(source, x.number, y.number, z.number));
    };
    const auto hear = [&](const EventView& event) {
        losses.hear(event);
        if (const auto operation = event.visit(OperationOf{})) ++found.operations[std::size_t(*operation)];
        if (const auto* fault = event.get_if<event::Fault>()) found.complete = found.complete && !ends_run(*fault);
        if (const auto* polygon = event.get_if<event::Polygon>()) scanned = polygon->polygon;
        if (const auto* depth = event.get_if<event::Depth>()) {
            look_at_depth(depth->polygon, depth->point.x, depth->point.y, depth->z);
        }
        if (const auto* pixel = event.get_if<event::Pixel>()) {
            look_at_depth(scanned, pixel->x + 0.5, pixel->y + 0.5, pixel->z);
        }
    };
    const bool by_picture_rule = reference_of(request.method) == Method::zbuffer;
    const CheckReport report =
        check_run(request, by_picture_rule ? right_ : right_picture(scene_, request.method), hear);
    found.losses = losses.all(polygon_names(request.scene));
    found.pixels = report.picture.pixels();
    found.wrong_pixels = report.wrong_pixels;
    found.area = visible_.wrong_in(report.picture);
    for (const auto& each : report.procedures) {
        found.decisions += each.decisions - each.undefined;
        found.wrong_decisions += each.wrong_for_scene;
    }
    return found;
}

std::size_t Examiner::unsteady_pixels() const {
    constexpr int trials = 16;
    RandomPolygons random(std::mt19937(1));
    std::vector<bool> changed(right_.pixels().size());
    for (int trial = 0; trial < trials; ++trial) {
        const Picture moved = picture_of(moved_by_ulps(scene_, 1, random));
        for (std::size_t i = 0; i < changed.size(); ++i) {
            changed[i] = changed[i] || moved.pixels()[i] != right_.pixels()[i];
        }
    }
    return std::size_t(std::count(changed.begin(), changed.end(), true));
}

}  // namespace vidno
