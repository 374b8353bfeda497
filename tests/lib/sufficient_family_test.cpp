// The trace is sufficient for the Warnock family, too.

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "support/sufficient.h"
#include "vidno/family/family.h"

using namespace vidno;
using namespace vidno::test;

TEST_CASE_TEMPLATE("Sufficient: the lists of the Warnock family", K, Double, Filtered, Exact) {
    RandomScenes random(12);
    int compared = 0;
    for (int i = 0; i < 25; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = i == 0 ? small_scene() : random.scene();
        for (std::size_t place = 0; place < method_names.size(); ++place) {
            const auto method = Method(place);
            if (!is_family(method)) continue;
            CAPTURE(method_names[place]);
            family::with_set_of(method, [&]<class Set>(Set) { compared += check_rebuilt<K, Set>(scene, method); });
        }
    }
    CHECK(compared > 1000);
}
