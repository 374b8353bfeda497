/// Checks that a trace is sufficient: compares the lists rebuilt from the events of a run with the run's own.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <concepts>

#include "rebuilt.h"
#include "replay/state.h"
#include "run/run.h"
#include "stage.h"

namespace vidno::test {

/// Records, and compares the procedure's own lists with the rebuilt ones wherever an event shows them.
template <class K>
class Compare : public RebuildingRecorder<K, State> {
    using Base = RebuildingRecorder<K, State>;
    using Base::rebuilt_;

public:
    using Base::Base;

    void push_root(Line at, const auto& windows) {
        Base::push_root(at, windows);
        compare_windows(windows);
    }
    void push_part(Line at, const auto& windows, bool shares_list) {
        Base::push_part(at, windows, shares_list);
        compare_windows(windows);
    }
    void summary(Line at, const auto& found) {
        Base::summary(at, found);
        const auto& rebuilt = rebuilt_->state.warnock().found();
        rebuilt_->expect(rebuilt.count == found.polygon_count && rebuilt.has_surround == found.has_surround);
    }
    void clip_list(Line at, const auto& vertices) {
        Base::clip_list(at, vertices);
        rebuilt_->expect(
            equal(vertices, rebuilt_->state.warnock().clip()->vertices, [](const auto& own, const auto& v) {
                return as_value<K>(own.x) == v.x && as_value<K>(own.y) == v.y && as_value<K>(own.z) == v.z;
            }));
    }
    void join(Line at, Relation relation, const auto& list) {
        Base::join(at, relation, list);
        compare_list(relation, list);
    }
    void rejoin(Line at, Relation relation, const auto& list) {
        compare_list(relation, list);
        Base::rejoin(at, relation, list);
    }
    void hiding(Line at, const auto* polygon) {
        Base::hiding(at, polygon);
        rebuilt_->expect(rebuilt_->state.warnock().found().has_surround == (polygon != nullptr));
    }
    void ael_sort(Line at, const auto& entries, const auto& next) {
        Base::ael_sort(at, entries, next);
        rebuilt_->expect(
            equal(entries, rebuilt_->state.z_buffer().active_edges(), [](const auto& own, const auto& entry) {
                return own.index == entry.edge && as_value<K>(own.x) == entry.x && as_value<K>(own.z) == entry.z &&
                       as_value<K>(own.dx) == entry.dx && as_value<K>(own.dz) == entry.dz;
            }));
    }

private:
    static bool equal(const auto& own, const auto& rebuilt, auto same) {
        return std::equal(own.begin(), own.end(), rebuilt.begin(), rebuilt.end(), same);
    }

    void compare_windows(const auto& windows) {
        const WarnockState& rebuilt = rebuilt_->state.warnock();
        rebuilt_->expect(equal(windows, rebuilt.stack(), [&](const auto& own, const auto& stacked) {
            return own.window == stacked.window &&
                   equal(*own.polygons, rebuilt.list(stacked).entries(), [](const auto& active, const auto& entry) {
                       return active.polygon->index == entry.first.index && active.surrounding == entry.second;
                   });
        }));
    }

    void compare_list(Relation relation, const auto& list) {
        const WarnockState& state = rebuilt_->state.warnock();
        const auto& rebuilt = relation == Relation::surrounding ? state.joined().surrounding : state.joined().outside;
        rebuilt_->expect(equal(list, rebuilt, [](const auto& own, const auto& entry) {
            return own.polygon->index == entry.polygon.index && own.level == entry.level;
        }));
    }
};

template <class K, class Set>
int check_rebuilt(const AdmittedScene& scene, Method method) {
    constexpr Edition edition = std::same_as<Set, Printed> ? Edition::printed : Edition::corrected;
    const TraceHeader header{method, edition, std::string(K::name), Detail::polygons, scene};
    Rebuilt<State> rebuilt(header);
    Stage<K, Set, Compare<K>> stage(scene, Compare<K>(rebuilt));
    try {
        is_warnock(method) ? Set::warnock(stage.run) : Set::z_buffer(stage.run);
    } catch (const Fault&) {
    }
    CHECK(rebuilt.different == 0);
    CHECK(rebuilt.state.picture() == stage.picture);
    if (is_warnock(method)) return rebuilt.compared;
    int different = 0;
    const Area& area = scene->area;
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            const typename K::Depth stored = stage.run.depth_buffer.at(x, y);
            const bool none = !stage.run.kernel.nearer(stored, stage.run.kernel.farthest(), Pixel{x, y});
            const Value own = none ? Value::minus_infinite() : as_value<K>(stage.run.kernel.finite(stored));
            different += own == rebuilt.state.screen().depths()->at(x, y) ? 0 : 1;
        }
    }
    CHECK_MESSAGE(different == 0, "cells of Z");
    return rebuilt.compared;
}

}  // namespace vidno::test
