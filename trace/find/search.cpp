#include "find/search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "choice/method.h"
#include "find/lattice_curves.h"
#include "find/lattice_scenes.h"
#include "find/measures.h"
#include "find/scene_size.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

constexpr std::size_t most_best = 24;            // of the best scenes
constexpr std::uint64_t least_patience = 20000;  // scenes tried after the last success

/// Scenes of polygons for a method.
struct Polygons {
    using Scene = AdmittedScene;
    Method method;

    std::optional<AdmittedScene> fresh(RandomPolygons& random, const Lattice& lattice) const {
        return choice_of(method).takes_closed_bodies ? random_body(random, lattice) : lattice_scene(random, lattice);
    }
    bool takes(const AdmittedScene& scene) const { return !refusal_of(method, scene); }
    std::vector<double> measured(const Condition& condition, const AdmittedScene& scene) const {
        return vidno::measured(condition, scene, method, kernel_of(KernelKind::filtered));
    }
    /// The scene as it is shown.
    static AdmittedScene named(const AdmittedScene& scene) { return lettered(scene); }
    static AnyScene any(const AdmittedScene& scene) { return scene; }
};

/// Curves for the floating horizon.
struct Curves {
    using Scene = AdmittedCurves;

    static std::optional<AdmittedCurves> fresh(RandomPolygons& random, const Lattice& lattice) {
        return lattice_curves(random, lattice);
    }
    static bool takes(const AdmittedCurves& scene) { return !scene->curves.empty(); }
    static std::vector<double> measured(const Condition& condition, const AdmittedCurves& scene) {
        return vidno::measured(condition, scene, kernel_of(KernelKind::filtered));
    }
    static AdmittedCurves named(const AdmittedCurves& scene) { return scene; }
    static AnyScene any(const AdmittedCurves& scene) { return Surface{{}, scene}; }
};

template <class Kind>
class Search {
public:
    Search(const SearchRequest& request, const Kind& kind)
        : request_(request), kind_(kind), random_(std::mt19937(std::uint32_t(request.seed ^ request.seed >> 32))) {
        report_.met.resize(request.condition.parts().size());
        report_.met_by_best.resize(report_.met.size());
    }

    SearchReport run() {
        while (!is_over()) {
            if (kept_.empty() || random_.whole(0, 2) == 0) {
                try_out(kind_.fresh(random_, lattice()));
            } else {
                // The better ones are changed more often.
                const int last = int(kept_.size()) - 1;
                const Kept& parent = kept_[std::size_t(std::min(random_.whole(0, last), random_.whole(0, last)))];
                try_out(changed_scene(parent.scene, random_, lattice()));
            }
        }
        if (!kept_.empty() && kept_.front().distance == 0) report_.found = kind_.any(kept_.front().scene);
        return std::move(report_);
    }

private:
    using Clock = std::chrono::steady_clock;
    using Scene = typename Kind::Scene;

    struct Kept {
        Scene scene;
        double distance;
        SceneSize size;

        bool operator<(const Kept& other) const {
            return distance != other.distance ? distance < other.distance : size < other.size;
        }
    };

    bool is_out_of_time() const {
        return std::chrono::duration<double>(Clock::now() - begin_).count() > request_.seconds;
    }

    bool is_over() const {
        if (is_out_of_time()) return true;
        return last_success_ > 0 && report_.scenes > last_success_ + std::max(least_patience, first_success_);
    }

    /// The growth doubles the scenes from one size to the next.
    Lattice lattice() {
        constexpr double first_scenes = 250;
        const int grown = int(std::log2(1 + double(report_.scenes) / first_scenes));
        Lattice lattice = Lattice::of_growth(grown);
        report_.widest = std::max(report_.widest, lattice.widest);
        report_.most_parts_drawn = std::max(report_.most_parts_drawn, std::size_t(lattice.most_polygons));
        // Once a scene is found, half of the scenes have no greater numbers than the smallest.
        constexpr double small = 8;
        const bool is_found = last_success_ > 0;
        if (is_found && random_.whole(0, 1) == 0 && kept_.front().size.coordinate() <= small) {
            const SceneSize& least = kept_.front().size;
            const Area& area = kept_.front().scene->area;
            lattice.widest = std::max(area.width, area.height);
            lattice.most_polygons = int(least.parts());
            lattice.greatest = std::max(1, int(least.coordinate()) - random_.whole(0, 1));
            lattice.is_coarse = true;
        }
        return lattice;
    }

    /// Measures a scene; true if it meets the condition.
    bool measure(const Scene& scene, double& distance) {
        ++report_.scenes;
        request_.progress(report_.scenes);
        const Condition& condition = request_.condition;
        const auto values = kind_.measured(condition, scene);
        distance = condition.distance(values);
        std::vector<bool> met;
        for (std::size_t part = 0; part < report_.met.size(); ++part) {
            met.push_back(condition.is_met(values, part));
            report_.met[part] += met.back() ? 1 : 0;
        }
        const auto parts = std::size_t(std::count(met.begin(), met.end(), true));
        if (parts > report_.most_parts) {
            report_.most_parts = parts;
            report_.met_by_best = met;
        }
        return distance == 0;
    }

    void try_out(const std::optional<Scene>& scene) {
        if (!scene || !kind_.takes(*scene)) return;
        double distance = 0;
        const bool is_met = measure(*scene, distance);
        Kept kept{*scene, distance, SceneSize(*scene)};
        if (kept_.size() >= most_best && !(kept < kept_.back())) return;
        const bool is_best = kept_.empty() || kept < kept_.front();
        keep(kept);
        if (!is_met || !is_best) return;
        last_success_ = report_.scenes;
        if (first_success_ > 0) return;
        first_success_ = report_.scenes;
        shrink();
    }

    void keep(Kept kept) {
        const auto place = std::lower_bound(kept_.begin(), kept_.end(), kept);
        if (place != kept_.end() && place->scene == kept.scene) return;
        kept_.insert(place, std::move(kept));
        if (kept_.size() > most_best) kept_.pop_back();
    }

    /// Shrinks the first scene that was found; changes make it smaller still.
    void shrink() {
        double distance = 0;
        const Scene smallest = shrunk(kept_.front().scene, [&](const Scene& smaller) {
            return !is_out_of_time() && kind_.takes(smaller) && measure(kind_.named(smaller), distance);
        });
        const Scene scene = kind_.named(smallest);
        keep({scene, 0, SceneSize(scene)});
        last_success_ = report_.scenes;
    }

    const SearchRequest& request_;
    Kind kind_;
    RandomPolygons random_;
    SearchReport report_;
    std::vector<Kept> kept_;  // the best first
    std::uint64_t first_success_ = 0, last_success_ = 0;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

SearchReport search(const SearchRequest& request) {
    if (request.method == floating_horizon_method) return Search(request, Curves{}).run();
    return Search(request, Polygons{method_named(request.method)}).run();
}

}  // namespace vidno
