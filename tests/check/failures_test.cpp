// The atlas of failures: each entry fails as stated under the weaker kernel or edition, and not under the stronger.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "check/check.h"
#include "check/seen_failure.h"
#include "output.h"
#include "run/floating_horizon_run.h"
#include "scene/sampling.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "support/curves.h"
#include "support/kettner.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"
#include "support/visitors.h"
#include "vidno/floating_horizon.h"
#include "vidno/printed_floating_horizon.h"
#include "vidno/viewport.h"

using namespace vidno;
using namespace vidno::test;
using nlohmann::json;

namespace {

struct Entry {
    std::string name;
    json document;
    std::optional<AnyScene> scene;  // none: a separate test shows the failure
};

AnyScene scene_in(const std::string& text, const std::string& name) {
    if (is_surface(text)) return read_surface(text, name);
    return read_scene(text, name).scene;
}

std::vector<Entry> atlas() {
    std::vector<Entry> entries;
    for (const auto& file : std::filesystem::directory_iterator(VIDNO_ROOT "/lessons/failures")) {
        if (file.path().extension() != ".json") continue;
        Entry entry{file.path().stem().string(), json::parse(read_file(file.path().string())), {}};
        if (entry.document.contains("scene")) entry.scene = scene_in(entry.document["scene"].dump(), entry.name);
        entries.push_back(std::move(entry));
    }
    return entries;
}

Method method_named(const std::string& name) {
    const auto found = std::find(method_names.begin(), method_names.end(), name);
    REQUIRE(found != method_names.end());
    return Method(found - method_names.begin());
}

Edition edition_in(const json& run) {
    const auto edition = edition_named(run.at("edition").get<std::string>());
    REQUIRE(edition);
    return *edition;
}

NamedKernel kernel_in(const json& run) { return *kernel_named(run.at("kernel").get<std::string>()); }

RunRequest request_of(const json& run, const AdmittedScene& scene) {
    return {method_named(run.at("method")), kernel_in(run), edition_in(run), scene, Detail::signs};
}

/// The signs of failure that a run shows.
class Shown {
public:
    Shown(const json& reported, const AdmittedScene& scene)
        : request_(request_of(reported, scene)), picture_(run(request_)) {
        const TraceHeader header{request_.method, request_.edition, request_.kernel.name(), Detail::signs, scene};
        TraceWriter writer(header, [&](std::string_view part) { trace_ += part; });
        request_.sink = &writer;
        writer.finish(run(request_));
    }

    const Picture& picture() const { return picture_; }
    bool reaches(const std::string& label) const { return has("\"at\":\"" + label + '"'); }
    bool faults_at(const std::string& label) const { return has(R"("e":"fault","at":")" + label + '"'); }
    std::size_t windows() const {
        std::size_t count = 0;
        for (auto at = trace_.find(R"("e":"pop")"); at != trace_.npos; at = trace_.find(R"("e":"pop")", at + 1))
            ++count;
        return count;
    }
    /// Does the procedure decide wrongly?
    bool wrong_in(const std::string& procedure) const {
        const CheckReport report = checked();
        for (const auto& each : report.procedures) {
            if (procedure_names[std::size_t(each.procedure)] == procedure) return each.wrong_for_scene > 0;
        }
        return false;
    }

    /// The farthest that an intersection is from the exact one, in pixels.
    double off() const { return checked().farthest_off; }
    /// The intersections, in their order; also under `filtered`, which does not survey them.
    std::vector<glm::dvec2> intersections() const {
        std::vector<glm::dvec2> found;
        checked([&](const EventView& event) {
            const auto* cut = event.get_if<event::ClipCross>();
            if (cut) found.emplace_back(cut->vertex.x.number, cut->vertex.y.number);
        });
        return found;
    }

private:
    CheckReport checked(const HearEvent& hear = [](const auto&) {}) const {
        return check_run(request_, right_picture(request_.scene), hear);
    }
    bool has(const std::string& text) const { return trace_.find(text) != trace_.npos; }

    RunRequest request_;
    Picture picture_;
    std::string trace_;
};

/// Checks one of the forms in which an entry describes the failure.
void check_shown(const std::string& form, const json& shown, const Shown& fails, const Shown& holds,
                 const Picture& right) {
    if (form == "pixel") {
        const int x = shown[0], y = shown[1];
        CHECK(fails.picture().at(x, y) != right.at(x, y));
        CHECK(holds.picture() == right);
    } else if (form == "wrong") {
        CHECK(fails.wrong_in(shown));
        CHECK_FALSE(holds.wrong_in(shown));
    } else if (form == "fault") {
        CHECK(fails.faults_at(shown));
        CHECK_FALSE(holds.faults_at(shown));
    } else if (form == "missing") {
        CHECK_FALSE(fails.reaches(shown));
        CHECK(holds.reaches(shown));
    } else if (form == "present") {
        CHECK(fails.reaches(shown));
        CHECK_FALSE(holds.reaches(shown));
    } else if (form == "off") {
        const auto computed = fails.intersections();
        const auto right_ones = holds.intersections();
        REQUIRE(computed.size() == right_ones.size());
        double farthest = 0;
        for (std::size_t i = 0; i < computed.size(); ++i) {
            farthest = std::max(farthest, glm::distance(computed[i], right_ones[i]));
        }
        CHECK(farthest >= shown.get<double>());
        CHECK_MESSAGE(std::abs(farthest - fails.off()) < 1e-9, "it is from the exact ones that they are off");
    } else {
        REQUIRE(form == "more_windows");
        CHECK(fails.windows() > holds.windows());
    }
}

void check_entry(const json& entry, const AdmittedScene& scene) {
    const Picture right = Reference(scene).picture();
    const Shown fails(entry.at("fails"), scene), holds(entry.at("holds"), scene);
    for (const auto& [form, shown] : entry.at("shows").items()) check_shown(form, shown, fails, holds, right);
}

/// The columns that the rule of the floating horizon draws.
ColumnsDrawn right_columns(const AdmittedCurves& curves) {
    ColumnsDrawn right;
    const FloatingHorizonReference reference(curves);
    for (const auto& seen : reference.curves()) right.push_back(seen.visible);
    return right;
}

/// The curves of a surface file; those of a function with a sample on each column.
AdmittedCurves true_curves(json surface) {
    if (surface.contains("function")) {
        surface["samples"] = surface.at("window").at("width");
        surface.erase("tolerance");
    }
    return read_surface(surface.dump(), "surface").curves;
}

/// Whether a curve is drawn at x, which may lie between columns.
bool is_drawn(const DrawnLines& lines, std::size_t curve, double x) {
    return std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
        return line.segment.curve == int(curve) && number_of(line.from.point.x) <= x && x <= number_of(line.to.point.x);
    });
}

void check_entry(const json& entry, const Surface& surface) {
    const AdmittedCurves& curves = surface.curves;
    const auto lines = [](const json& shown, const AdmittedCurves& scene) {
        REQUIRE(shown.at("method") == floating_horizon_method);
        return run(FloatingHorizonRequest{kernel_in(shown), edition_in(shown), scene});
    };
    const auto drawn = [&](const json& shown, const AdmittedCurves& scene) {
        return columns_drawn(lines(shown, scene), scene);
    };
    const ColumnsDrawn right = right_columns(true_curves(entry.at("scene"))), fails = drawn(entry.at("fails"), curves);
    for (const auto& [form, shown] : entry.at("shows").items()) {
        const std::size_t curve = shown[0];
        if (form == "place") {
            CHECK(is_drawn(lines(entry.at("fails"), curves), curve, shown[1]) !=
                  is_drawn(lines(entry.at("holds"), curves), curve, shown[1]));
            continue;
        }
        REQUIRE(form == "column");
        const auto column = std::size_t(shown[1].get<int>() - curves->curves[curve].samples.front().x);
        CHECK(fails[curve][column] != right[curve][column]);
    }
    const json& holds = entry.at("holds");
    const bool has_own = holds.contains("scene");  // the same surface, sampled otherwise
    CHECK(drawn(holds, has_own ? read_surface(holds["scene"].dump(), "holds").curves : curves) == right);
}

}  // namespace

TEST_CASE("Failures: each entry of the atlas fails as it says, and its remedy does not") {
    int scenes = 0;
    for (const Entry& entry : atlas()) {
        CAPTURE(entry.name);
        CHECK(entry.document.at("format") == "vidno-failure/1");
        for (const std::string text : {"title", "why", "remedy"}) {
            for (const std::string language : {"en", "ru"}) {
                CHECK_FALSE(entry.document.at(text).at(language).get<std::string>().empty());
            }
        }
        if (!entry.scene) continue;
        ++scenes;
        REQUIRE_FALSE(entry.document.at("shows").empty());
        std::visit([&](const auto& scene) { check_entry(entry.document, scene); }, *entry.scene);
    }
    CHECK(scenes >= 30);
}

TEST_CASE("Failures: the step at which a pixel is seen is the one that paints it, by each algorithm") {
    // N covers (8, 8) and lies in front of Q.
    const AdmittedScene scene =
        SceneBuilder(area_16).polygon("Q", red, far_quad).polygon("N", green, near_square).build();
    for (const auto& [method, paints] : std::to_array<std::pair<std::string, std::string>>(
             {{"warnock", "fill"}, {"zbuffer", "span"}, {"weiler-atherton", "paint"}})) {
        Failure failure;
        failure.scene = scene;
        failure.fails = failure.holds = {method, kernel_of(KernelKind::exact), Edition::corrected};
        CAPTURE(failure.fails.method);
        failure.shows.pixel = std::pair(8, 8);
        const SeenFailure found = seen(failure);
        CHECK(found.there.english == "N is painted, not N");
        REQUIRE(found.step);

        std::string trace;
        write_failing_run(failure, [&](std::string_view part) { trace += part; });
        std::istringstream lines(trace);
        std::string line;
        for (std::uint64_t at = 0; at <= *found.step; ++at) std::getline(lines, line);  // the header is line 0
        CHECK(json::parse(line).at("e") == paints);
    }
}

TEST_CASE(
    "Failures: a pixel that the Z-buffer only clears is seen wrong at no step, by Warnock's algorithm at its fill") {
    // N covers (8, 8), not (1, 1).
    const AdmittedScene scene = SceneBuilder(area_16).polygon("N", green, near_square).build();
    for (const auto& [method, has_step] :
         std::to_array<std::pair<std::string, bool>>({{"warnock", true}, {"zbuffer", false}})) {
        Failure failure;
        failure.scene = scene;
        failure.fails = failure.holds = {method, kernel_of(KernelKind::exact), Edition::corrected};
        CAPTURE(failure.fails.method);
        failure.shows.pixel = std::pair(1, 1);
        const SeenFailure found = seen(failure);
        CHECK(found.there.english == "the background is painted, not the background");
        CHECK(found.step.has_value() == has_step);
    }
}

TEST_CASE("Failures: an entry without a scene has a test of its name") {
    const std::string tests = read_file(VIDNO_ROOT "/tests/check/failures_test.cpp");
    for (const Entry& entry : atlas()) {
        if (entry.scene) continue;
        CAPTURE(entry.name);
        CHECK(tests.find("TEST_CASE(\"" + entry.document.at("test").get<std::string>() + "\")") != std::string::npos);
    }
}

TEST_CASE("Failures: the pivot of an orientation changes its rounded sign") {
    int differing = 0, differing_exactly = 0;
    const KettnerMap& map = kettner_maps[0];
    map.for_each_place([&](const glm::dvec3& p) {
        const auto signs_differ = [&](const auto& kernel) {
            const auto of = [&](const auto& pivot, const auto& a, const auto& b) {
                return kernel.sign(kernel.cross(kernel.vertex(pivot), kernel.vertex(a), kernel.vertex(b)));
            };
            return of(p, map.q, map.r) != of(map.q, map.r, p);
        };
        differing += signs_differ(Double{}) ? 1 : 0;
        differing_exactly += signs_differ(Exact{}) ? 1 : 0;
    });
    CHECK(differing > 0);
    CHECK(differing_exactly == 0);
}

TEST_CASE("Failures: a fused multiply-add changes the sign of an orientation") {
    const double ax = .1, ay = .1, bx = .3, by = .3;
    CHECK(ax * by - ay * bx == 0);
    CHECK(Rational(ax) * Rational(by) - Rational(ay) * Rational(bx) == 0);
    CHECK(std::fma(ax, by, -(ay * bx)) != 0);
}

TEST_CASE("Failures: clipping a clipped polygon changes it") {
    // The triangle of the entry clip-pixel, by each window of 1 x 1, and what is left by the same window again.
    const AdmittedScene scene = SceneBuilder(area_16).polygon({{-3, 4, 0}, {18, 1, 0}, {7, 12, 0}}).build();
    const auto changed = [&]<class K>(K) {
        Stage<K> stage(scene);
        int count = 0;
        for (double y = 0; y < 16; ++y) {
            for (double x = 0; x < 16; ++x) {
                Polygon<K> once = stage.polygon();
                once.vertices = Corrected::polygon_clip(stage.run, stage.polygon(), Window{x, y, 1, 1});
                if (once.vertices.empty()) continue;
                const auto twice = Corrected::polygon_clip(stage.run, once, Window{x, y, 1, 1});
                const auto same = [](const auto& v, const auto& w) { return v.x == w.x && v.y == w.y; };
                count +=
                    std::equal(twice.begin(), twice.end(), once.vertices.begin(), once.vertices.end(), same) ? 0 : 1;
            }
        }
        return count;
    };
    CHECK(changed(Double{}) > 0);
    CHECK(changed(Exact{}) == 0);
}

TEST_CASE("Failures: halving a window stalls where there are no halves") {
    const float x = 0x1p24F, width = 1;
    CHECK(x + width / 2 == x);
    Window window = covering_square({farthest_offset, farthest_offset, largest_side, largest_side});
    while (window.width > 1) {
        const WindowParts parts = parts_of(window);
        const Window last = *std::prev(parts.end());
        CHECK(last.x > window.x);
        CHECK(last.width == window.width / 2);
        window = last;
    }
}

TEST_CASE("Failures: windows along the line where two planes meet") {
    // z = x / 16 and z = (11 - x) / 16 meet at x = 5 1/2. At each level the windows across that line are split into
    // four: 1 + 4 (1 + 2 + 4 + 8) = 61 on 16 x 16 pixels; on 32 x 32 with the planes drawn twice as large, 61 + 4 * 16
    // = 125.
    const auto windows = [](int side) {
        const double s = side;
        const auto plane = [&](double left, double right) {
            return Corners{{0, 0, left}, {s, 0, right}, {s, s, right}, {0, s, left}};
        };
        const double at = side / 2 - 2.5;  // where they meet
        int count = 0;
        render<Corrected>(
            Method::warnock,
            SceneBuilder({0, 0, side, side}).polygon(plane(0, 1)).polygon(plane(2 * at / s, 2 * at / s - 1)).build(),
            Exact{}, CountWindows(count));
        return count;
    };
    CHECK(windows(16) == 61);
    CHECK(windows(32) == 125);
}

TEST_CASE("Failures: no order of painting resolves a cyclic overlap") {
    const std::string file = VIDNO_ROOT "/lessons/01-four-relations/cycle.json";
    const AdmittedScene scene = read_scene(read_file(file), file).scene;
    const Picture right = Reference(scene).picture();
    std::vector<std::size_t> order(scene->polygons.size());
    std::iota(order.begin(), order.end(), 0);
    do {
        Picture painted(scene->area, scene->background);
        for (const std::size_t index : order) {
            Scene alone = scene;
            alone.polygons = {scene->polygons[index]};
            const Picture one = Reference(alone).picture();
            for (int y = scene->area.y; y < scene->area.bottom(); ++y) {
                for (int x = scene->area.x; x < scene->area.right(); ++x) {
                    if (one.at(x, y) != scene->background) painted.paint(x, y, one.at(x, y));
                }
            }
        }
        CHECK(painted != right);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("Failures: the printed viewport puts the picture above the area") {
    // y' = -(Wy/2) y + Wcy - Wy/2: with Wcy = 20 and Wy = 4 the range is 16 to 20, and the area's 20 to 24.
    const Area area{10, 20, 6, 4};
    const glm::dmat4 corrected = viewport_matrix(area);
    glm::dmat4 printed = corrected;
    printed[3][1] = area.y - area.height / 2.0;
    const auto painted = [&](const glm::dmat4& viewport) {
        Corners corners;
        for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            corners.emplace_back(viewport * glm::dvec4(corner, 0, 1));
        }
        const AdmittedScene scene = SceneBuilder(area).polygon(std::move(corners)).build();
        return different_pixels(render(Method::zbuffer, scene, Exact{}), Picture(area, scene->background));
    };
    CHECK(painted(corrected) == 24);
    CHECK(painted(printed) == 0);
}

TEST_CASE("Failures: an empty list has no least element") {
    // At the end of each of two polygons S and AEL are empty, in both editions, so no next row may come.
    const AdmittedScene scene =
        SceneBuilder(area_16).quad(2.25, 2.25, 8.25, 8.25, 0).quad(4.5, 4.5, 12.5, 12.5, .5).build();
    const Picture right = right_picture(scene);
    for (const Edition edition : {Edition::corrected, Edition::printed}) {
        int without_next = 0;
        const auto hear = [&](const EventView& event) {
            const auto* drop = event.get_if<event::AelDrop>();
            without_next += drop && std::isinf(drop->next.number) ? 1 : 0;
        };
        check_run({Method::zbuffer, *kernel_named("double"), edition, scene}, right, hear);
        CHECK(without_next == 2);
    }
}

namespace {

/// X-W10: every entry of APL has a third element I, whether its polygon is inside, which the parts of a window inherit.
/// Once a polygon is inside a window, it meets only that window and its parts from then on: one mark for each polygon
/// is enough.
struct InsideInherited : Corrected {
    mutable std::set<int> inside;

    WindowSummary process_window(auto& run, const Window& window, auto& active_polygons) const {
        WindowSummary found = Corrected::process_window(run, window, active_polygons);
        for (const auto& entry : active_polygons) {
            if (run.kernel.inside(entry.polygon->box, window)) inside.insert(entry.polygon->index);
        }
        if (found.polygon_count == 1) found.insider = inside.count(active_polygons.front().polygon->index) > 0;
        return found;
    }
};

/// X-W11: PointColor counts from 1 in a list whose first element has the number 0.
struct PointColorFromOne : Corrected {
    static Color point_color(auto& run, const auto& point, const auto& active_polygons) {
        auto examined = active_polygons;
        examined.erase(examined.begin());
        return Corrected::point_color(run, point, examined);
    }
};

}  // namespace

TEST_CASE("Failures: an inherited mark for inside draws a polygon over its neighbours") {
    // A and the nearer B are inside the area, so the area is split. Its lower right part, where B lies, is finished
    // first. A alone is in the other three and extends beyond each of them: drawn whole, it covers B.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8}).quad(1, 1, 7, 7, 0).quad(5, 5, 6, 6, .5).build();
    Picture without_b(scene->area, white);
    for (int y = 1; y < 7; ++y) {
        for (int x = 1; x < 7; ++x) without_b.paint(x, y, color_of(0));
    }
    Picture right = without_b;
    right.paint(5, 5, color_of(1));
    CHECK(render<Corrected>(Method::warnock, scene, Exact{}) == right);
    CHECK(render<InsideInherited>(Method::warnock, scene, Exact{}) == without_b);
}

TEST_CASE("Failures: PointColor from 1 skips the first element of a list from 0") {
    // The square holds the centre of the only pixel and none of its corners: PointColor decides.
    const AdmittedScene scene = SceneBuilder({0, 0, 1, 1}).quad(.25, .25, .75, .75, 0).build();
    CHECK(render<Corrected>(Method::warnock, scene, Exact{}).at(0, 0) == color_of(0));
    CHECK(render<PointColorFromOne>(Method::warnock, scene, Exact{}).at(0, 0) == white);
}

namespace {

/// for z = first to last step `step`: z stops beyond the last value, in the direction of the step.
std::vector<double> values_of_loop(double first, double last, double step) {
    std::vector<double> values;
    for (double z = first; step > 0 ? z <= last : z >= last; z += step) values.push_back(z);
    return values;
}

}  // namespace

TEST_CASE("Failures: a loop from Zmax to Zmin with a positive step draws nothing") {
    const double zmin = 0, zmax = 4, step = 1;
    const auto curves_drawn = [&](double signed_step) {
        CurveSceneBuilder surface({0, 0, 9, 9});  // y = 8 - z: all curves are visible
        for (const double z : values_of_loop(zmax, zmin, signed_step)) surface.curve({{0, 8 - z}, {8, 8 - z}});
        std::set<int> drawn;
        for (const auto& line : visible_lines(surface.build(), Exact{}).lines) drawn.insert(line.segment.curve);
        return drawn;
    };
    CHECK(curves_drawn(-step) == std::set{0, 1, 2, 3, 4});
    CHECK(curves_drawn(step).empty());
}

TEST_CASE("Failures: without the minus in exp the figure is 10^8 high") {
    const double pi = std::acos(-1.0);
    const auto highest = [&](double sign) {
        double found = 0;
        for (int i = 0; i <= 40; ++i) {
            for (int j = 0; j <= 40; ++j) {
                const double x = 2 * pi * i / 40, z = 2 * pi * j / 40;
                const double a = (x - pi) * (x - pi) + (z - pi) * (z - pi);
                const double y = std::sin(x) * std::cos(z) / 5 - 1.5 * std::cos(7 * a / 4) * std::exp(sign * a);
                found = std::max(found, std::abs(y));
            }
        }
        return found;
    };
    // With the minus |y| <= 1/5 + 3/2. Without it, at a corner, a = 2 pi^2 = 19.739: 3/2 |cos 34.544| exp(19.739), and
    // 34.544 = 11 pi - 0.014: the cosine is -1 but for 1e-4, and exp(19.739) = 3.738e8.
    CHECK(highest(-1) <= 1.7);
    CHECK(highest(1) == doctest::Approx(1.5 * 3.738e8).epsilon(1e-3));
}

namespace {

// The corrected procedures, with one rule of the text each.
struct BelowLost : CorrectedFloatingHorizon {  // X-H1
    static bool draws(VisibilityFlag side) { return PrintedFloatingHorizon::draws(side); }
};
struct EdgeLost : CorrectedFloatingHorizon {  // X-H1
    static bool no_edge_yet(const std::optional<Sample>& edge) { return PrintedFloatingHorizon::no_edge_yet(edge); }
};
struct StepsOfSamples : CorrectedFloatingHorizon {  // X-H5
    static int next_column(const Segment& segment, int x) { return PrintedFloatingHorizon::next_column(segment, x); }
};
struct WrongHorizonMet
    : StepsOfSamples {  // X-H2; where steps are of a column, no column is lost by it, but a part of one
    static VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) {
        return PrintedFloatingHorizon::horizon_met(was, is);
    }
};

/// Does this one of the rules in which the text differs from the corrected procedures show what the entry shows?
template <class Set>
bool shows_alone(const std::string& name) {
    const std::string file = VIDNO_ROOT "/lessons/failures/" + name + ".json";
    const json entry = json::parse(read_file(file));
    const AdmittedCurves curves = read_surface(entry.at("scene").dump(), file).curves;
    DrawnLines drawn;
    for (const auto& [segment, from, to] : visible_lines<Set>(curves, Exact{}).lines) {
        drawn.push_back({segment, {{}, from.left, from.right}, {{}, to.left, to.right}});
    }
    return columns_drawn(drawn, curves) != right_columns(curves);
}

}  // namespace

TEST_CASE("Failures: defects of the printed floating horizon show alone") {
    CHECK(shows_alone<BelowLost>("x-h1"));
    CHECK(shows_alone<EdgeLost>("x-h1-edge"));
    CHECK(shows_alone<WrongHorizonMet>("x-h2"));
    for (const auto* name : {"x-h1", "x-h1-edge", "x-h2"}) CHECK_FALSE(shows_alone<CorrectedFloatingHorizon>(name));
    CHECK_FALSE(shows_alone<StepsOfSamples>("x-h2"));
}
