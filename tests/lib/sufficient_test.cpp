// The trace is sufficient: states rebuilt from its events are those of the run.

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "support/sufficient.h"

using namespace vidno;
using namespace vidno::test;

TEST_CASE_TEMPLATE("Sufficient: states rebuilt from the events equal the algorithm's own", K, VIDNO_KERNELS) {
    RandomScenes random(11);
    int compared = 0;
    for (int i = 0; i < 25; ++i) {
        CAPTURE(i);
        const AdmittedScene scene = scene_for<K>(i == 0 ? small_scene() : random.scene());
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            compared += check_rebuilt<K, Corrected>(scene, method);
            if constexpr (PrintedKernel<K>) compared += check_rebuilt<K, Printed>(scene, method);
        }
    }
    CHECK(compared > 1000);
}
