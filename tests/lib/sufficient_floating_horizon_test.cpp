// The trace of the floating horizon is sufficient: lines and horizons rebuilt from its events are those of the run.

#include <doctest/doctest.h>

#include "replay/floating_horizon_state.h"
#include "support/kernels.h"
#include "support/random_curves.h"
#include "support/rebuilt.h"
#include "vidno/floating_horizon.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/printed_floating_horizon.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// Records, and compares the run's horizons with the rebuilt ones whenever they may have changed.
template <class K>
class CompareHorizons : public RebuildingRecorder<K, FloatingHorizonState> {
    using Base = RebuildingRecorder<K, FloatingHorizonState>;
    using Base::rebuilt_;

public:
    using Base::Base;

    void horizons(Line at, const Horizons<OnColumns<K>>& own) {
        Base::horizons(at, own);
        own_ = &own;
        compare();
    }
    void horizon(Line at, const Segment& segment, int first, int last) {
        Base::horizon(at, segment, first, last);
        compare();
    }
    void raise(Line at, int column, const auto& y) {
        Base::raise(at, column, y);
        if (rebuilt_->recording.detail == Detail::signs) compare();
    }

private:
    void compare() {
        const Area& area = rebuilt_->state.header().scene.curves->area;
        for (int x = area.x; x < area.right(); ++x) {
            const auto column = std::size_t(x - area.x);
            expect(own_->upper[x], rebuilt_->state.values().horizons.upper[column]);
            expect(own_->lower[x], rebuilt_->state.values().horizons.lower[column]);
        }
    }
    void expect(const auto& own, const std::optional<Value>& reported) {
        rebuilt_->expect(own ? reported && as_value<K>(*own) == *reported : !reported);
    }

    const Horizons<OnColumns<K>>* own_ = nullptr;  // of the run that is reported
};

template <class Set, class K>
void check_rebuilt(const AdmittedCurves& scene) {
    constexpr Edition edition = std::same_as<Set, PrintedFloatingHorizon> ? Edition::printed : Edition::corrected;
    for (const Detail detail : {Detail::polygons, Detail::signs}) {
        const FloatingHorizonHeader header{edition, std::string(K::name), detail, {"", scene}};
        Rebuilt<FloatingHorizonState> rebuilt(header);
        const auto own = visible_lines<Set>(scene, K{}, CompareHorizons<K>(rebuilt)).lines;
        CHECK(rebuilt.compared >= 2 * scene->area.width);
        CHECK(rebuilt.different == 0);
        CHECK(rebuilt.state.calls().size() == 1);
        REQUIRE(rebuilt.state.values().lines.size() == own.size());
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto same = [](const auto& a, const LineEnd<Value>& b) {
                return as_value<K>(a.point.x) == b.point.x && as_value<K>(a.point.y) == b.point.y && a.left == b.left &&
                       a.right == b.right;
            };
            CHECK(rebuilt.state.values().lines[i].segment == own[i].segment);
            CHECK(same(own[i].from, rebuilt.state.values().lines[i].from));
            CHECK(same(own[i].to, rebuilt.state.values().lines[i].to));
        }
    }
}

}  // namespace

TEST_CASE_TEMPLATE("Sufficient: lines and horizons rebuilt from the events are the run's own, at every change", K,
                   VIDNO_PRINTED_KERNELS, Filtered) {
    RandomCurves random(19);
    for (int i = 0; i < 60; ++i) {
        CAPTURE(i);
        AdmittedCurves scene = i == 0 ? some_curves() : random.scene();
        if (i % 3 == 1) scene = with_gaps(scene, random);
        check_rebuilt<CorrectedFloatingHorizon, K>(scene);
        if constexpr (PrintedKernel<K>) check_rebuilt<PrintedFloatingHorizon, K>(scene);
    }
}
