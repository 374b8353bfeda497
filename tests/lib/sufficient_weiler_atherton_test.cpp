// The trace of Weiler and Atherton's algorithm is sufficient: lists rebuilt from its events are those of the run.

#include <doctest/doctest.h>

#include "replay/state.h"
#include "support/kernels.h"
#include "support/rebuilt.h"
#include "support/scenes.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/weiler_atherton.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// Records, and compares the procedure's own lists with the rebuilt ones wherever an event shows them.
template <class K>
class CompareRegions : public RebuildingRecorder<K, State> {
    using Base = RebuildingRecorder<K, State>;
    using Base::rebuilt_;

public:
    using Base::Base;

    void facets(Line at, const auto& pieces) {
        Base::facets(at, pieces);
        compare(pieces, rebuilt_->state.weiler_atherton().facets());
    }
    void push_list(Line at, const auto& pieces) {
        // The outside list is pushed before the inside one is examined; its pieces have already been reported.
        if (at == Line::WA6) compare(pieces, rebuilt_->state.weiler_atherton().current_list()->outside);
        Base::push_list(at, pieces);
        compare(pieces, rebuilt_->state.weiler_atherton().lists().back());
    }
    void pop_list(Line at, const auto& pieces) {
        Base::pop_list(at, pieces);
        compare(pieces, rebuilt_->state.weiler_atherton().current_list()->pieces);
    }
    void nearer_ones(Line at, const auto& pieces) {
        Base::nearer_ones(at, pieces);
        compare(pieces, rebuilt_->state.weiler_atherton().current_list()->inside);
    }

private:
    void compare(const auto& own, const WeilerAthertonState::Pieces& rebuilt) {
        std::vector<PolygonPart> parts;
        for (const auto& piece : own) {
            auto& part = parts.emplace_back(PolygonPart{{piece.polygon->index}, {}, piece.is_ground});
            for (const auto& loop : piece.region.loops) {
                part.region.emplace_back();
                for (const auto& v : loop) part.region.back().push_back({as_value<K>(v.at.x), as_value<K>(v.at.y)});
            }
        }
        const auto is_part = [](const PolygonPart& part, const auto& piece) { return part == *piece; };
        rebuilt_->expect(std::ranges::equal(parts, rebuilt, is_part));
    }
};

/// Three bars, each over the next.
AdmittedScene cycle() {
    return SceneBuilder(area_16)
        .quad(1, 2, 15, 5, .5)
        .polygon({{11, 1, .90625}, {14, 1, .90625}, {14, 15, -.40625}, {11, 15, -.40625}})
        .polygon({{2, 0, 0}, {4, 0, 0}, {16, 12, .75}, {14, 12, .75}})
        .build();
}

}  // namespace

// Not under `filtered`, which may report a number twice, more precisely the second time.
TEST_CASE_TEMPLATE(
    "Sufficient: lists, facets and what is visible of regions, rebuilt from the events, are the run's own", K, Float,
    Double, Exact) {
    RandomScenes random(41);
    int compared = 0;
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = i == 0 ? cycle() : random.scene();
        Rebuilt<State> rebuilt(
            TraceHeader{Method::weiler_atherton, Edition::corrected, std::string(K::name), Detail::polygons, scene});
        const auto visible = visible_regions(scene, K{}, CompareRegions<K>(rebuilt));
        CHECK(rebuilt.different == 0);
        CHECK(rebuilt.state.picture() == visible.picture);
        REQUIRE(rebuilt.state.weiler_atherton().visible().size() == visible.regions.size());
        for (std::size_t k = 0; k < visible.regions.size(); ++k) {
            CHECK(rebuilt.state.weiler_atherton().visible()[k]->polygon.index == visible.regions[k].polygon);
        }
        compared += rebuilt.compared;
    }
    CHECK(compared > 200);
}
