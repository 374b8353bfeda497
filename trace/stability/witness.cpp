#include "stability/witness.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "choice/method.h"
#include "run/floating_horizon_run.h"
#include "scene/scene_json.h"
#include "scene/surface.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

/// The first error of a run: a pixel, or a curve and a column.
using WrongPlace = std::pair<int, int>;

std::optional<WrongPlace> wrong_pixel(const AdmittedScene& scene, Method method, const NamedKernel& kernel) {
    if (refusal_of(method, scene)) return std::nullopt;
    const Picture painted = run({method, kernel, Edition::corrected, scene});
    const Picture right = run({reference_of(method), kernel_of(KernelKind::filtered), Edition::corrected, scene});
    const Area& area = scene->area;
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            if (painted.at(x, y) != right.at(x, y)) return WrongPlace{x, y};
        }
    }
    return std::nullopt;
}

std::optional<WrongPlace> wrong_column(const AdmittedCurves& scene, const NamedKernel& kernel) {
    const auto drawn = [&](const NamedKernel& by) {
        return columns_drawn(run(FloatingHorizonRequest{by, Edition::corrected, scene}), scene);
    };
    const ColumnsDrawn taken = drawn(kernel), right = drawn(kernel_of(KernelKind::filtered));
    for (std::size_t curve = 0; curve < taken.size(); ++curve) {
        const auto [is, should] = std::mismatch(taken[curve].begin(), taken[curve].end(), right[curve].begin());
        if (is == taken[curve].end()) continue;
        return WrongPlace{int(curve), scene->curves[curve].samples.front().x + int(is - taken[curve].begin())};
    }
    return std::nullopt;
}

/// The failure file. The remedy is the kernel that is always right.
std::string failure_of(const std::string& scene, const Family& family, const std::string& method,
                       const std::string& kernel, const char* shown, const WrongPlace& place) {
    const auto run = [&](const std::string& under) {
        return Json{{"method", method}, {"kernel", under}, {"edition", "corrected"}};
    };
    const std::string name = std::string(family.name);
    const InEachLanguage<std::string> title{method + " under " + kernel + ": " + name,
                                            method + ", числа " + kernel + ": " + name};
    const InEachLanguage<std::string> why{
        "The smallest scene that was found in the family " + name + ": " + std::string(family.shows) + ".",
        "Наименьшая сцена, найденная в семействе " + name + "."};
    constexpr Bilingual remedy{"Decide by an error bound, and exactly where the bound cannot decide: kernel filtered.",
                               "Решать по границе погрешности, а где её не хватает — точно: числа filtered."};
    const Json failure{{"format", "vidno-failure/1"},
                       {"title", object_of<Json>(title)},
                       {"why", object_of<Json>(why)},
                       {"remedy", object_of<Json>(remedy)},
                       {"fails", run(kernel)},
                       {"holds", run("filtered")},
                       {"shows", {{shown, {place.first, place.second}}}},
                       {"scene", Json::parse(scene)}};
    return failure.dump(1) + "\n";
}

}  // namespace

std::optional<std::string> witness(const Campaign& campaign, const Family& family, const Experiment& experiment,
                                   std::uint64_t first, const std::string& method, const std::string& kernel,
                                   const Property& where, const std::function<void()>& progress) {
    const NamedKernel named = *kernel_named(kernel);
    const auto tried = std::find(method_names.begin(), method_names.end(), method);
    const auto wrong_in = [&](const AdmittedScene& scene) {
        progress();
        return wrong_pixel(scene, Method(tried - method_names.begin()), named);
    };
    const auto of_scene = [&](const AdmittedScene& scene) {
        const auto wrong = wrong_in(scene);
        return wrong && where && !where(scene) ? std::nullopt : wrong;
    };
    bool is_first = true;
    const auto of_curves = [&](const AdmittedCurves& scene) {
        progress();
        return where ? std::nullopt : wrong_column(scene, named);
    };
    for (std::uint64_t trial = first; trial < campaign.count; ++trial) {
        const TrialScenes scenes = scenes_of(campaign.seed, family, experiment, trial);
        if (const auto* curves = std::get_if<AdmittedCurves>(&scenes)) {
            if (!of_curves(*curves)) continue;
            const AdmittedCurves smallest =
                shrunk(*curves, [&](const AdmittedCurves& smaller) { return of_curves(smaller).has_value(); });
            return failure_of(surface_json({std::string(family.name), smallest}), family, method, kernel, "column",
                              *of_curves(smallest));
        }
        const AdmittedScene& scene = std::get<std::vector<AdmittedScene>>(scenes).front();
        if (!wrong_in(scene)) continue;
        // Every witness begins as a larger scene. The one kept without a condition may meet it once it is small.
        const bool meets = !where || where(scene);
        if (!meets && !std::exchange(is_first, false)) continue;
        const AdmittedScene smallest = shrunk(scene, [&](const AdmittedScene& smaller) {
            return (meets ? of_scene(smaller) : wrong_in(smaller)).has_value();
        });
        if (const auto pixel = of_scene(smallest)) {
            return failure_of(scene_json(smallest), family, method, kernel, "pixel", *pixel);
        }
    }
    return std::nullopt;
}

}  // namespace vidno
