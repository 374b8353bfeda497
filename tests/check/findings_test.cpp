// The list of decisions: what it holds, against hand calculations and counts in rationals that know the scene and the picture rule alone.

#include <doctest/doctest.h>

#include <set>
#include <tuple>

#include "check/check.h"
#include "check/checked_trace.h"
#include "check/findings_text.h"
#include "support/scenes.h"
#include "vidno/kernels/exact.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// A run's findings, and what else `vidno check` says of it.
struct Checked {
    std::vector<Finding> findings;
    CheckReport report;
};

Checked checked(const Scene& scene, Method method, std::string_view kernel, std::size_t narrowest = 20) {
    FindingList list(choice_of(method).procedure, scene.area, narrowest);
    const RunRequest request{method, *kernel_named(kernel), Edition::corrected, scene};
    CheckReport report = check_run(
        request, right_picture(scene, method), [](const auto&) {}, &list);
    return {list.findings(), std::move(report)};
}

std::vector<Finding> of_kind(const Checked& checked, FindingKind kind) {
    std::vector<Finding> found;
    for (const auto& each : checked.findings) {
        if (each.kind == kind) found.push_back(each);
    }
    return found;
}

/// Polygons and pixels as the picture rule has them, in rationals.
class InRationals {
public:
    /// The ends of the closed polygon on a row's centre line; none if it does not reach it. One of no width counts as it does for the
    /// rule: not at all.
    std::optional<std::pair<Rational, Rational>> ends(const ScenePolygon& polygon, int row) const {
        if (polygon.edge_on) return std::nullopt;
        const Rational y = Rational(row) + half;
        std::optional<std::pair<Rational, Rational>> found;
        const auto& v = polygon.vertices;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const auto& p = v[i];
            const auto& q = v[(i + 1) % v.size()];
            const Rational py(p.y), qy(q.y), px(p.x), qx(q.x);
            if ((y < py && y < qy) || (y > py && y > qy)) continue;
            const auto include = [&](const Rational& x) {
                if (!found) found.emplace(x, x);
                found->first = std::min(found->first, x);
                found->second = std::max(found->second, x);
            };
            if (py == qy) {
                include(px);
                include(qx);
            } else {
                include(px + (y - py) * (qx - px) / (qy - py));
            }
        }
        return found;
    }

    bool holds(const ScenePolygon& polygon, int x, int y) const {
        const auto on_row = ends(polygon, y);
        const Rational centre = Rational(x) + half;
        return on_row && on_row->first <= centre && centre <= on_row->second;
    }

    /// The depth of the polygon's plane at a point, by three of its vertices.
    static Rational depth(const ScenePolygon& polygon, const Rational& x, const Rational& y) {
        const auto& v = polygon.vertices;
        for (std::size_t i = 1; i + 1 < v.size(); ++i) {
            const Rational ux = Rational(v[i].x) - Rational(v[0].x), uy = Rational(v[i].y) - Rational(v[0].y);
            const Rational wx = Rational(v[i + 1].x) - Rational(v[0].x), wy = Rational(v[i + 1].y) - Rational(v[0].y);
            const Rational area = ux * wy - uy * wx;
            if (area == 0) continue;
            const Rational dx = x - Rational(v[0].x), dy = y - Rational(v[0].y);
            const Rational s = (dx * wy - dy * wx) / area, t = (ux * dy - uy * dx) / area;
            return Rational(v[0].z) + s * (Rational(v[i].z) - Rational(v[0].z)) +
                   t * (Rational(v[i + 1].z) - Rational(v[0].z));
        }
        FAIL("a polygon without area has no plane");
        return 0;
    }

    /// Whether all vertices lie in one plane exactly: then it is the same by any three of them.
    static bool is_planar(const ScenePolygon& polygon) {
        return polygon.edge_on || std::all_of(polygon.vertices.begin(), polygon.vertices.end(), [&](const auto& v) {
                   return depth(polygon, Rational(v.x), Rational(v.y)) == Rational(v.z);
               });
    }

private:
    const Rational half = Rational(1) / 2;
};

using PolygonAtPixel = std::tuple<int, int, int>;        // a polygon, x, y
using PolygonsAtPixel = std::tuple<int, int, int, int>;  // two polygons, the nearer one so far last, x, y

}  // namespace

TEST_CASE("A square with its corners on pixel centres: the list names its coincidences and nothing else of them") {
    // From (0.5, 0.5) to (2.5, 2.5) on 4 x 4 pixels: rows 0 to 2, whose left ends are the centre of column 0 and right ends that of 2.
    const Scene scene = SceneBuilder({0, 0, 4, 4}).quad(.5, .5, 2.5, 2.5, .25).build();
    const Checked found = checked(scene, Method::zbuffer, "double");
    std::set<std::pair<int, int>> pixels;
    for (const auto& each : of_kind(found, FindingKind::zero)) {
        CHECK(each.gap->exact.text == "0/1");
        const bool of_columns =
            each.procedure == Procedure::show_line && each.gap->if_zero == Coincidence::on_pixel_centre;
        if (of_columns) pixels.emplace(each.pixels.x, each.pixels.y);
    }
    CHECK(pixels == std::set<std::pair<int, int>>{{0, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {2, 2}});
    CHECK(of_kind(found, FindingKind::wrong).empty());
}

TEST_CASE("A wrong decision is listed with what it was taken on") {
    // As a float 1/2 + 2^-30 is 1/2: the left end of the only row is the centre of column 0 by the float, and beyond it by the scene. There
    // the floats are 2^-24 apart: the two numbers are 2^-30 / 2^-24 = 1/64 ulp from each other.
    const Scene scene = SceneBuilder({0, 0, 4, 1}).quad(.5 + 0x1p-30, 0, 3, 1, .25).build();
    FindingList list(Procedure::z_buffer, scene.area, 0);
    const RunRequest request{Method::zbuffer, *kernel_named("float"), Edition::corrected, scene};
    const CheckReport report = check_run(
        request, right_picture(scene), [](const auto&) {}, &list);
    CHECK(report.wrong_pixels == 1);
    std::vector<Finding> wrong;
    for (const auto& each : list.findings()) {
        if (each.kind == FindingKind::wrong) wrong.push_back(each);
    }
    REQUIRE(wrong.size() == 1);
    const std::string step = std::to_string(wrong[0].step);
    const std::string operands = R"([["x","1/2","536870913/1073741824"],["low","0/1","0/1"],["end","4/1","4/1"]])";
    const std::string lines = findings_jsonl(findings_header(request), wrong);
    CHECK(
        lines ==
        "{\"format\":\"vidno-decisions/"
        "1\",\"method\":\"zbuffer\",\"edition\":\"corrected\",\"kernel\":\"float\",\"scene\":\"\"}\n"
        "{\"kind\":\"wrong\",\"step\":" +
            step +
            ",\"at\":\"L4\",\"procedure\":\"ShowLine\",\"polygons\":[\"A\"],\"pixels\":[0,0,1,1],"
            "\"of\":\"first_centre\",\"taken\":0,\"exact\":1,\"cause\":\"drifted\",\"coincidence\":\"on_pixel_centre\","
            "\"computed\":0,\"gap\":\"1/1073741824\",\"sign\":1,\"ulps\":0.015625,\"operands\":" +
            operands + "}\n");
    CHECK(
        findings_csv(findings_header(request), wrong) ==
        "kind,step,at,procedure,of,polygons,pixels,taken,exact,cause,coincidence,computed,gap,sign,ulps,off,operands\n"
        "wrong," +
            step +
            ",L4,ShowLine,first_centre,A,\"[0,0,1,1]\",0,1,drifted,on_pixel_centre,0,1/1073741824,1,0.015625,,"
            "x = 1/2 (536870913/1073741824); low = 0/1; end = 4/1\n");
}

TEST_CASE(
    "A checked trace tells the operands beside a decision and at a disagreement, which stands where the list says") {
    // The scene of the test above.
    const Scene scene = SceneBuilder({0, 0, 4, 1}).quad(.5 + 0x1p-30, 0, 3, 1, .25).build();
    std::string trace;
    const RunRequest request{Method::zbuffer, *kernel_named("float"), Edition::corrected, scene, Detail::signs};
    TraceWriter writer(TraceHeader{request.method, request.edition, "float", request.detail, scene},
                       [&](std::string_view part) { trace += part; });
    write_checked_trace(request, writer);
    const std::string right = R"(,["right","3/1","3/1"],["low","0/1","0/1"],["end","4/1","4/1"]])";
    CHECK(trace.find(R"("exact":[1,3],"operands":[["left","1/2","536870913/1073741824"])" + right + "}\n" +
                     R"({"e":"disagree","at":"L4","of":"first_centre","taken":0,"exact":1,"cause":"drifted",)" +
                     R"("operands":[["x","1/2","536870913/1073741824"],["low","0/1","0/1"],["end","4/1","4/1"]]})") !=
          std::string::npos);
    // It is the only one, and the report's first step is that of the event before it.
    CHECK(trace.find("disagree") == trace.rfind("disagree"));
    const auto report = check_run(request, right_picture(scene));
    const auto before = std::count(trace.begin(), trace.begin() + std::ptrdiff_t(trace.find("disagree")), '\n');
    REQUIRE(report.procedures.size() == 2);
    CHECK(report.procedures[1].procedure == Procedure::show_line);
    CHECK(report.procedures[1].first_wrong == std::uint64_t(before) - 1);  // less the header
}

TEST_CASE("The narrowest decisions: as many as are asked for, none narrower is left out") {
    RandomScenes random(21);
    for (int i = 0; i < 40 / thinning; ++i) {
        const Scene scene = random.scene();
        const auto few = of_kind(checked(scene, Method::warnock, "double", 5), FindingKind::narrow);
        auto all = of_kind(checked(scene, Method::warnock, "double", 1'000'000), FindingKind::narrow);
        REQUIRE(few.size() == std::min<std::size_t>(5, all.size()));
        std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.gap->ulps < b.gap->ulps; });
        for (const auto& each : few) CHECK(each.gap->ulps <= all[few.size() - 1].gap->ulps);
        for (const auto& each : all) CHECK(each.gap->sign != Sign::zero);
    }
}

TEST_CASE(
    "On 1,000 scenes the Z-buffer's zeros are the pixel centres on outlines and the equal depths that the picture rule "
    "has") {
    RandomScenes random(22);
    std::size_t on_outlines = 0, equal_depths = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        Scene scene = random.scene();
        // In every other scene a polygon is there twice.
        if (i % 2 == 1) {
            scene.polygons.push_back(scene.polygons[std::size_t(random.whole(0, int(scene.polygons.size()) - 1))]);
            scene.polygons.back().id = "copy";
        }
        const InRationals exact;
        const Area& area = scene.area;

        const Rational half = Rational(1) / 2;
        // The centres at an end of a polygon on a row; and where a polygon is exactly as near as the nearest before it.
        std::set<PolygonAtPixel> ends;
        std::set<PolygonsAtPixel> ties;
        const bool planar = std::all_of(scene.polygons.begin(), scene.polygons.end(), InRationals::is_planar);
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int p = 0; p < int(scene.polygons.size()); ++p) {
                const auto on_row = exact.ends(scene.polygons[std::size_t(p)], y);
                if (!on_row) continue;
                for (int x = area.x; x < area.right(); ++x) {
                    const Rational centre = Rational(x) + half;
                    if (centre == on_row->first || centre == on_row->second) ends.emplace(p, x, y);
                }
            }
            for (int x = area.x; planar && x < area.right(); ++x) {
                int nearest = -1;
                Rational depth;
                for (int p = 0; p < int(scene.polygons.size()); ++p) {
                    const auto& polygon = scene.polygons[std::size_t(p)];
                    if (!exact.holds(polygon, x, y)) continue;
                    const Rational z = InRationals::depth(polygon, Rational(x) + half, Rational(y) + half);
                    if (nearest >= 0 && z == depth) ties.emplace(p, nearest, x, y);
                    if (nearest >= 0 && z <= depth) continue;
                    nearest = p;
                    depth = z;
                }
            }
        }

        for (const std::string_view kernel : {"exact", "filtered"}) {
            std::set<PolygonAtPixel> listed_ends;
            std::set<PolygonsAtPixel> listed_ties;
            for (const auto& each : of_kind(checked(scene, Method::zbuffer, kernel, 0), FindingKind::zero)) {
                const auto& [x, y, width, height] = each.pixels;
                const auto is = [&](Coincidence of) { return each.gap->if_zero == of; };
                if (each.procedure == Procedure::show_line && is(Coincidence::on_pixel_centre)) {
                    REQUIRE(width * height == 1);
                    listed_ends.emplace(each.polygons.at(0).index, x, y);
                }
                // A row with a level edge is shown twice: there a polygon is compared with itself.
                if (is(Coincidence::equal_depths) && each.polygons.size() == 2) {
                    listed_ties.emplace(each.polygons[0].index, each.polygons[1].index, x, y);
                }
            }
            CHECK(listed_ends == ends);
            if (planar) CHECK(listed_ties == ties);
        }
        on_outlines += ends.size();
        equal_depths += ties.size();
    }
    CHECK(on_outlines > 1000 / thinning);
    CHECK(equal_depths > 100 / thinning);
}

TEST_CASE(
    "On 1,000 scenes the zeros of SurroundTest are the points that lie on the line of the edge they were asked of") {
    RandomScenes random(23);
    std::size_t zeros = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        CAPTURE(i);
        const Scene scene = random.scene();
        // From the trace the questions alone are taken: which point, which edge.
        std::set<std::uint64_t> expected;
        std::uint64_t step = 0;
        HeardBy hear([&](const EventView& event) {
            ++step;
            const auto* orient = event.get_if<event::Orient>();
            if (!orient) return;
            const auto& v = scene.polygons[std::size_t(orient->polygon.index)].vertices;
            const auto& p = v[std::size_t(orient->edge)];
            const auto& q = v[(std::size_t(orient->edge) + 1) % v.size()];
            const Rational x(orient->point.x.number), y(orient->point.y.number);
            const Rational twice_area = (Rational(q.x) - Rational(p.x)) * (y - Rational(p.y)) -
                                        (Rational(q.y) - Rational(p.y)) * (x - Rational(p.x));
            if (twice_area == 0) expected.insert(step);
        });
        const RunRequest request{
            Method::warnock, *kernel_named("filtered"), Edition::corrected, scene, Detail::signs, &hear};
        run(request);
        std::set<std::uint64_t> listed;
        for (const auto& each : of_kind(checked(scene, Method::warnock, "filtered", 0), FindingKind::zero)) {
            if (each.procedure == Procedure::surround_test) listed.insert(each.step);
        }
        CHECK(listed == expected);
        zeros += expected.size();
    }
    CHECK(zeros > 1000 / thinning);
}

TEST_CASE("A constructed point half a pixel off is an error, and the report says at which step") {
    // The edges of a sliver are nearly parallel to a side of the window: cut there, with 8 bits, they come out pixels away.
    RandomScenes random(24);
    int off = 0;
    for (int i = 0; i < 200 / thinning; ++i) {
        const Scene scene = random.scene();
        const Checked found = checked(scene, Method::warnock, "bits:5");
        const auto points = of_kind(found, FindingKind::point);
        CHECK(found.report.points_off == points.size());
        if (points.empty()) continue;
        ++off;
        CHECK(found.report.found_something());
        const auto farthest =
            std::max_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.off < b.off; });
        CHECK(farthest->off == found.report.farthest_off);
        CHECK(farthest->step == found.report.farthest_step);
        for (const auto& each : points) {
            CHECK(each.off > .5);
            CHECK(each.at == Line::PL5);
        }
    }
    CHECK(off > 0);
}
