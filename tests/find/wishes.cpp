/// Whether `vidno find` finds what is wished, and what is smallest.
///
/// Takes   the file of wishes, the most seconds for each, and `all`, or nothing to leave out what is slow.
/// Does    searches for each wish and runs what was found under the exact kernel; then enumerates all small scenes for
///         other conditions, and compares the smallest with what the search finds. The enumeration shares no code with
///         the search.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

#include "choice/method.h"
#include "find/measures.h"
#include "find/scene_size.h"
#include "find/search.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

std::string_view method_of(const Condition& condition, const std::string& name) {
    return name.empty() ? method_for(condition) : std::string_view(name);
}

SceneSize size_of(const AnyScene& found) {
    const auto* surface = std::get_if<Surface>(&found);
    return surface ? SceneSize(*surface->curves) : SceneSize(*std::get<AdmittedScene>(found));
}

/// Whether a scene is found and meets the condition in exact arithmetic.
bool is_granted(const std::string& text, const std::string& method_name, double seconds) {
    const Condition condition(text);
    const std::string_view method = method_of(condition, method_name);
    const SearchReport report = search({.condition = condition, .method = method, .seconds = seconds});
    const NamedKernel exact = kernel_of(KernelKind::exact);
    const bool granted = report.found && condition.is_met(measured(condition, *report.found, method, exact));
    std::cout << (granted ? "found     " : "not found ") << text << "  (" << report.scenes << " scenes)\n";
    return granted;
}

// ------------------------------------------------------------------------------------- all small scenes

using Outline = std::vector<glm::dvec3>;

/// All triangles whose coordinates are -most to most in units of 1 or 1/2, level at a depth of 0, or also of 1; each in
/// both directions.
std::vector<Outline> all_triangles(int most, bool also_nearer) {
    std::vector<Outline> all;
    for (const double unit : {1.0, 0.5}) {
        std::vector<glm::dvec3> points;
        for (int x = -most; x <= most; ++x) {
            for (int y = -most; y <= most; ++y) points.emplace_back(x * unit, y * unit, 0);
        }
        for (std::size_t a = 0; a < points.size(); ++a) {
            for (std::size_t b = 0; b < points.size(); ++b) {
                for (std::size_t c = a + 1; c < points.size(); ++c) {
                    if (b <= a || b == c) continue;
                    for (const double z : {0.0, 1.0}) {
                        if (z > 0 && !also_nearer) continue;
                        Outline outline{points[a], points[b], points[c]};
                        for (auto& vertex : outline) vertex.z = z;
                        all.push_back(outline);
                    }
                }
            }
        }
    }
    return all;
}

/// The size of the smallest of all scenes of some small triangles in areas of up to two by two pixels, or three in a
/// row.
std::optional<SceneSize> smallest(const Condition& condition, Method method, int polygons) {
    const auto triangles = all_triangles(polygons == 1 ? 3 : 1, polygons > 1);
    std::optional<SceneSize> least;
    const auto try_out = [&](Scene scene) {
        const SceneSize size(scene);
        if (least && !(size < *least)) return;
        const AdmittedScene admitted = exact_scene::admit(std::move(scene));
        if (condition.is_met(measured(condition, admitted, method, kernel_of(KernelKind::filtered)))) least = size;
    };
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 2}}) {
        for (const Outline& first : triangles) {
            Scene scene;
            scene.area = {0, 0, width, height};
            scene.polygons.push_back({"A", {1, 0, 0}, first, false});
            if (polygons == 1) {
                try_out(scene);
                continue;
            }
            for (const Outline& second : triangles) {
                Scene both = scene;
                both.polygons.push_back({"B", {2, 0, 0}, second, false});
                try_out(std::move(both));
            }
        }
    }
    return least;
}

/// All curves whose heights are -2 to 2 units, over any two columns or more.
std::vector<Curve> all_curves(int columns, double unit) {
    std::vector<Curve> all{{}};
    for (int x = 0; x < columns; ++x) {
        for (const Curve& begun : std::vector(all)) {
            for (int y = -2; y <= 2; ++y) {
                all.push_back(begun);
                all.back().samples.push_back({x, y * unit});
            }
        }
    }
    std::erase_if(all, [](const Curve& curve) { return curve.samples.size() < 2; });
    return all;
}

/// The size of the smallest of all scenes of one or two such curves over two or three columns, one pixel high.
std::optional<SceneSize> smallest_curves(const Condition& condition) {
    std::optional<SceneSize> least;
    const auto try_out = [&](CurveScene scene) {
        const SceneSize size(scene);
        if (least && !(size < *least)) return;
        if (condition.is_met(measured(condition, admit(std::move(scene)), kernel_of(KernelKind::filtered))))
            least = size;
    };
    for (const int columns : {2, 3}) {
        for (const double unit : {1.0, 0.5}) {
            const auto curves = all_curves(columns, unit);
            for (const Curve& nearer : curves) {
                try_out({{0, 0, columns, 1}, {nearer}});
                for (const Curve& farther : curves) try_out({{0, 0, columns, 1}, {nearer, farther}});
            }
        }
    }
    return least;
}

struct Smallest {
    const char* condition;
    int polygons;  // 0: curves
    const char* method = "";
    bool differs = false;  // the search may find a scene that is a little larger
};

constexpr Smallest compared[]{
    {"PW7 > 0", 1},
    {"PL5 == 8", 1},
    {"F2 == 2 && W11 == 1", 1},
    {"Z16 > 0 && Z17 == 0", 1},
    {"PL7 > 0 && PL5 == 0", 1},
    {"pixels(A) == 2", 1},
    {"L6 == 3", 1, "", true},
    {"wrong(float) > 0", 1},
    {"Z9 > 0", 1},
    {"L2 > 0", 1},
    {"splits > 0", 2},
    {"W8 > 0 && polygons == 2", 2, "", true},
    {"PC4 == 2", 2, "", true},
    {"WF10 > 0", 2, "warnock-full", true},
    {"FH6 > 0", 0},
    {"FH7 > 0 && FH8 > 0", 0},
    {"V1 == 6 && FH6 < 4", 0},
    {"SE2 > 0", 0},
    {"IN2 == 2", 0},
    {"H2 > H3", 0},
    {"samples == 5 && FH8 == 2", 0},
};

/// Whether the search finds a scene as small as the enumeration.
bool is_smallest(const Smallest& each, double seconds) {
    const Condition condition(each.condition);
    const std::string_view method = method_of(condition, each.method);
    const auto least =
        each.polygons == 0 ? smallest_curves(condition) : smallest(condition, method_named(method), each.polygons);
    const SearchReport report = search({.condition = condition, .method = method, .seconds = seconds});
    const auto text = [](const std::optional<SceneSize>& size) {
        std::ostringstream numbers;
        if (!size)
            numbers << " none";
        else
            for (const double number : size->numbers) numbers << ' ' << number;
        return numbers.str();
    };
    const auto found = report.found ? std::optional<SceneSize>(size_of(*report.found)) : std::nullopt;
    const bool agrees = least.has_value() == found.has_value() && (!least || *found == *least);
    std::cout << (agrees ? "smallest  " : "differs   ") << each.condition << "  enumerated" << text(least) << ", found"
              << text(found) << '\n';
    return agrees;
}

int test(const std::string& file, double seconds, bool all) {
    std::ifstream wishes(file);
    std::cout << std::unitbuf;  // so that a test that is stopped says how far it came
    int wished = 0, granted = 0, compared_ones = 0, agreeing = 0;
    for (std::string line; std::getline(wishes, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream columns(line);
        std::string condition, method, slow;
        std::getline(std::getline(std::getline(columns, condition, '\t'), method, '\t'), slow);
        if (!all && !slow.empty()) continue;
        ++wished;
        granted += is_granted(condition, method, seconds) ? 1 : 0;
    }
    for (const Smallest& each : compared) {
        if (!all && each.differs) continue;
        ++compared_ones;
        agreeing += is_smallest(each, seconds) ? 1 : 0;
    }
    std::cout << granted << " of " << wished << " wishes found; " << agreeing << " of " << compared_ones
              << " as small as can be\n";
    if (!all) return wished == 23 && granted == wished && agreeing == compared_ones ? 0 : 1;
    return wished == 30 && granted >= 27 && agreeing >= 10 ? 0 : 1;
}

}  // namespace

}  // namespace vidno

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    return vidno::test(argv[1], std::stod(argv[2]), argc > 3 && std::string_view(argv[3]) == "all");
}
