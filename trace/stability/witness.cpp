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
                                   const Where& where, const std::function<void()>& progress) {
    const NamedKernel named = *kernel_named(kernel);
    const auto meets = [&](const AnyScene& scene) { return !where || where(scene); };
    bool is_first = true;
    // The smallest scene that is wrong and meets the condition, with the first error.
    const auto smallest = [&]<class T>(const T& scene, const auto& any,
                                       const auto& wrong_in) -> std::optional<std::pair<T, WrongPlace>> {
        const auto wrong = [&](const T& tried) {
            progress();
            return wrong_in(tried);
        };
        if (!wrong(scene)) return std::nullopt;
        // Every witness begins as a larger scene. The one kept without a condition may meet it once it is small.
        const bool from_begin = meets(any(scene));
        if (!from_begin && !std::exchange(is_first, false)) return std::nullopt;
        const T least = shrunk(scene, [&](const T& smaller) {
            return wrong(smaller).has_value() && (!from_begin || meets(any(smaller)));
        });
        if (!meets(any(least))) return std::nullopt;
        return std::pair{least, *wrong(least)};
    };
    for (std::uint64_t trial = first; trial < campaign.count; ++trial) {
        const TrialScenes scenes = scenes_of(campaign.seed, family, experiment, trial);
        if (const auto* curves = std::get_if<AdmittedCurves>(&scenes)) {
            const auto surface = [&](const AdmittedCurves& each) { return Surface{std::string(family.name), each}; };
            const auto found =
                smallest(*curves, surface, [&](const AdmittedCurves& each) { return wrong_column(each, named); });
            if (!found) continue;
            return failure_of(surface_json(surface(found->first)), family, method, kernel, "column", found->second);
        }
        const auto same = [](const AdmittedScene& each) { return each; };
        const auto found =
            smallest(std::get<std::vector<AdmittedScene>>(scenes).front(), same,
                     [&](const AdmittedScene& each) { return wrong_pixel(each, method_named(method), named); });
        if (found) return failure_of(scene_json(found->first), family, method, kernel, "pixel", found->second);
    }
    return std::nullopt;
}

}  // namespace vidno
