#include "stability/experiment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "check/check.h"
#include "choice/method.h"
#include "scene/exact_scene.h"
#include "scene/snapped_scene.h"

namespace vidno {

namespace {

using Series = std::vector<AdmittedScene>;
using Pictures = std::vector<Picture>;

// ------------------------------------------------------------------------------------- the scenes of a trial

Series moved_by(const Family& family, RandomPolygons& random, std::int64_t ulps) {
    const AdmittedScene scene = random_scene(family, random);
    return {ulps > 0 ? moved_by_ulps(scene, ulps, random) : scene};
}

/// The last polygon moves to the right in 256 steps; halfway it is where the family puts it.
template <class StepOf>
Series swept_over(const Family& family, RandomPolygons& random, StepOf step_of) {
    const Scene halfway = random_scene(family, random);
    const double step = step_of(halfway.polygons.back());
    Series series;
    for (int i = -128; i <= 128; ++i) {
        Scene scene = halfway;
        for (auto& vertex : scene.polygons.back().vertices) vertex.x += i * step;
        series.push_back(admitted(std::move(scene)));
    }
    return series;
}

Series swept_by_ulps(const Family& family, RandomPolygons& random, std::int64_t) {
    return swept_over(family, random, [](const ScenePolygon& polygon) {
        double farthest = 0;
        for (const auto& vertex : polygon.vertices) farthest = std::max(farthest, std::abs(vertex.x));
        return std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
    });
}

Series swept_by_a_pixel(const Family& family, RandomPolygons& random, std::int64_t) {
    return swept_over(family, random, [](const ScenePolygon&) { return 1.0 / 256; });
}

void move(Scene& scene, auto&& where) {
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) vertex = where(vertex);
    }
}

/// A scene near coincidences, and its transformed versions.
template <class Change>
Series changed_by(const Family& family, RandomPolygons& random, Change change) {
    const AdmittedScene scene = moved_by_ulps(random_scene(family, random), 1, random);
    Scene other = scene;
    change(other);
    return {scene, admitted(std::move(other))};
}

Series begun_elsewhere(const Family& family, RandomPolygons& random, std::int64_t) {
    return changed_by(family, random, [](Scene& scene) {
        for (auto& polygon : scene.polygons) {
            std::rotate(polygon.vertices.begin(), polygon.vertices.begin() + 1, polygon.vertices.end());
        }
    });
}

Series reversed(const Family& family, RandomPolygons& random, std::int64_t) {
    return changed_by(family, random, [](Scene& scene) {
        for (auto& polygon : scene.polygons) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    });
}

Series reordered(const Family& family, RandomPolygons& random, std::int64_t) {
    return changed_by(family, random, [](Scene& scene) { std::reverse(scene.polygons.begin(), scene.polygons.end()); });
}

Series shifted(const Family& family, RandomPolygons& random, std::int64_t) {
    return changed_by(family, random, [](Scene& scene) {
        move(scene, [](const glm::dvec3& v) { return v + glm::dvec3(1000, -37, 0); });
        scene.area.x += 1000;
        scene.area.y -= 37;
    });
}

void grow(Scene& scene, int times) {
    move(scene, [&](const glm::dvec3& v) { return glm::dvec3(times * v.x, times * v.y, v.z); });
    const auto [x, y, width, height] = scene.area;
    scene.area = {times * x, times * y, times * width, times * height};
}

/// Grown and shifted by half a pixel: the centre of the pixel (i, j) becomes that of (2i, 2j).
Series doubled(const Family& family, RandomPolygons& random, std::int64_t) {
    return changed_by(family, random, [](Scene& scene) {
        grow(scene, 2);
        move(scene, [](const glm::dvec3& v) { return v - glm::dvec3(.5, .5, 0); });
    });
}

Series grown_to(const Family& family, RandomPolygons& random, std::int64_t side) {
    Scene scene = random_scene(family, random);
    grow(scene, int(side) / family_side);
    return {exact_scene::admit(std::move(scene))};
}

// ------------------------------------------------------------------------------------- what a trial comes to

Tally with_pixels(Tally tally, std::size_t pixels, std::size_t wrong_pixels) {
    ++tally.runs;
    tally.wrong_runs += wrong_pixels > 0 ? 1 : 0;
    tally.pixels += pixels;
    tally.wrong_pixels += wrong_pixels;
    return tally;
}

Tally with_decisions(Tally tally, const DecisionReport& report) {
    for (const auto& each : report.procedures) {
        tally.decisions += each.decisions - each.undefined;
        tally.wrong_decisions += each.wrong_for_scene;
    }
    return tally;
}

Tally look_at_decisions(const RunRequest& request) {
    const CheckReport report = check_run(request, right_picture(request.scene, request.method));
    const Area& area = request.scene->area;
    Tally tally = with_pixels({}, std::size_t(area.width) * std::size_t(area.height), report.wrong_pixels);
    return with_decisions(tally, report);
}

Tally look_at_windows(RunRequest request) {
    Tally tally;
    if (request.method != Method::warnock) return tally;
    tally.runs = 1;
    request.progress = [&] { ++tally.windows; };
    run(request);
    return tally;
}

Pictures pictures_of(const Series& series, Method method, const NamedKernel& kernel) {
    Pictures pictures;
    for (const auto& scene : series) pictures.push_back(run({method, kernel, Edition::corrected, scene}));
    return pictures;
}

Pictures exact_pictures_of(const Series& series, Method method) {
    return pictures_of(series, reference_of(method), kernel_of(KernelKind::exact));
}

/// The colours at the centres of the family's area: in a picture k times as large, every k-th pixel of every k-th row.
std::vector<Color> sampled(const Picture& picture) {
    const Area& area = picture.area();
    const int step = area.width / family_side;
    std::vector<Color> colors;
    for (int y = area.y; y < area.bottom(); y += step) {
        for (int x = area.x; x < area.right(); x += step) colors.push_back(picture.at(x, y));
    }
    return colors;
}

Tally look_at_pixels(const Pictures& pictures, const Pictures& right) {
    Tally tally;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        tally = with_pixels(tally, pictures[i].pixels().size(), different_pixels(pictures[i], right[i]));
        if (i == 0) continue;
        const auto before = sampled(pictures[i - 1]), after = sampled(pictures[i]);
        const auto right_before = sampled(right[i - 1]), right_after = sampled(right[i]);
        for (std::size_t pixel = 0; pixel < after.size(); ++pixel) {
            if (right_before[pixel] != right_after[pixel]) continue;
            ++tally.steady;
            tally.flickers += before[pixel] != after[pixel] ? 1 : 0;
        }
    }
    return tally;
}

/// Whether the kernel runs the method, and the method takes the scenes.
bool takes(Method method, const NamedKernel& kernel, const Series& series) {
    return kernel.choice->runs(method, Edition::corrected) &&
           std::none_of(series.begin(), series.end(), [&](const Scene& scene) { return refusal_of(method, scene); });
}

/// Whether the kernel's numbers hold the scenes.
bool holds(const NamedKernel& kernel, const Series& series) {
    const auto fits = [&](const Scene& scene) { return fits_grid(scene, kernel.parameter); };
    return !kernel.snaps() || std::all_of(series.begin(), series.end(), fits);
}

Series snapped_series(Series series, int bits) {
    for (auto& scene : series) scene = snapped_scene(scene, bits).scene;
    return series;
}

}  // namespace

using enum Experiment::Kind;

const std::array<Experiment, 21> experiments{{
    {moved, "0", 0, 1, moved_by},
    {moved, "1", 1, 1, moved_by},
    {moved, "2", 2, 1, moved_by},
    {moved, "4", 4, 1, moved_by},
    {moved, "16", 16, 1, moved_by},
    {moved, "2^8", 1 << 8, 1, moved_by},
    {moved, "2^16", 1 << 16, 1, moved_by},
    {moved, "2^32", std::int64_t{1} << 32, 1, moved_by},
    {swept, "by ulps", 0, 256, swept_by_ulps},
    {swept, "by a pixel", 0, 256, swept_by_a_pixel},
    {changed, "begun elsewhere", 0, 2, begun_elsewhere},
    {changed, "reversed", 0, 2, reversed},
    {changed, "reordered", 0, 2, reordered},
    {changed, "shifted", 0, 2, shifted},
    {changed, "doubled", 0, 2, doubled},
    {grown, "8", 8, 64, grown_to},
    {grown, "16", 16, 64, grown_to},
    {grown, "32", 32, 64, grown_to},
    {grown, "64", 64, 64, grown_to},
    {grown, "128", 128, 64, grown_to},
    {grown, "256", 256, 64, grown_to},
}};

Tally& Tally::operator+=(const Tally& other) {
    for (const auto& [name, value] : tally_fields) this->*value += other.*value;
    skipped += other.skipped;
    const auto middle = failing.insert(failing.end(), other.failing.begin(), other.failing.end());
    std::inplace_merge(failing.begin(), middle, failing.end());
    failing.resize(std::min(failing.size(), most_failing));
    return *this;
}

Tallies try_out(const Experiment& experiment, const Series& series, const std::vector<NamedKernel>& kernels,
                const std::vector<TriedMethod>& methods) {
    const bool at_all_pixels = experiment.kind == swept || experiment.kind == changed;
    Tallies tallies;
    // The exact pictures of the series before snapping, by reference method, since most methods paint the same.
    std::map<Method, Pictures> right_as_given;
    for (const auto& kernel : kernels) {
        if (!holds(kernel, series)) {
            for (const TriedMethod& method : methods) {
                tallies.emplace_back();
                tallies.back().skipped = method && kernel.choice->runs(*method, Edition::corrected) ? 1 : 0;
            }
            continue;
        }
        const Series own = kernel.snaps() ? snapped_series(series, kernel.parameter) : series;
        std::map<Method, Pictures> right_of_own;
        auto& right = kernel.snaps() ? right_of_own : right_as_given;
        const auto right_of = [&](Method method) -> const Pictures& {
            const auto [found, is_new] = right.try_emplace(reference_of(method));
            if (is_new && at_all_pixels) found->second = exact_pictures_of(own, method);
            return found->second;
        };
        for (const TriedMethod& method : methods) {
            tallies.emplace_back();
            if (!method || !takes(*method, kernel, own)) continue;
            const RunRequest request{*method, kernel, Edition::corrected, own.front()};
            switch (experiment.kind) {
                case moved: tallies.back() = look_at_decisions(request); break;
                case swept:
                case changed:
                    tallies.back() = look_at_pixels(pictures_of(own, *method, kernel), right_of(*method));
                    break;
                case grown: tallies.back() = look_at_windows(request); break;
            }
        }
    }
    return tallies;
}

Tallies try_out(const AdmittedCurves& scene, const std::vector<NamedKernel>& kernels,
                const std::vector<TriedMethod>& methods) {
    Tallies tallies;
    for (const auto& kernel : kernels) {
        for (const TriedMethod& method : methods) {
            tallies.emplace_back();
            if (method || !kernel.choice->runs_floating_horizon(Edition::corrected)) continue;
            const auto report = check_run(FloatingHorizonRequest{kernel, Edition::corrected, scene});
            tallies.back() = with_decisions(with_pixels({}, report.columns, report.wrong_columns), report);
        }
    }
    return tallies;
}

}  // namespace vidno
