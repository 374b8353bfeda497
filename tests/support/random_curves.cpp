#include "random_curves.h"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace vidno::test {

AdmittedCurves RandomCurves::scene() {
    const Area area{whole(-9, 9), 0, whole(2, 14), 16};
    CurveSceneBuilder builder(area);
    const int kind = whole(0, 3);
    std::vector<Curve> curves;
    for (int i = whole(2, 7); i > 0; --i) {
        curves.push_back(!curves.empty() && whole(0, 3) == 0
                             ? variant(curves[std::size_t(whole(0, int(curves.size()) - 1))])
                             : curve(area, kind));
        builder.curve(curves.back().samples);
    }
    return builder.build();
}

Curve RandomCurves::curve(const Area& area, int kind) {
    const bool cropped = whole(0, 2) == 0;
    const int first = cropped ? whole(area.x, area.right() - 2) : area.x;
    const int last = cropped ? whole(first + 1, area.right() - 1) : area.right() - 1;
    const int longest = whole(1, 6);
    Curve made;
    for (int x = first; x < last; x += whole(1, longest)) made.samples.push_back({x, height(kind)});
    made.samples.push_back({last, height(kind)});
    return made;
}

double RandomCurves::height(int kind) {
    switch (kind) {
        case 0: return whole(0, 4);
        case 1: return whole(0, 3) == 0 ? whole(0, 1) * 16 : 8;  // peaks
        case 2: return whole(-64, 1088) / 64.;
        default: return whole(0, 30) / 10.;  // tenths, which doubles do not represent exactly
    }
}

/// The curve again, perhaps mirrored in a horizontal line and with fewer samples.
Curve RandomCurves::variant(Curve made) {
    auto& samples = made.samples;
    if (whole(0, 1) == 0) {
        for (auto& [x, y] : samples) y = 4 - y;
    }
    for (std::size_t i = samples.size() - 2; i > 0; --i) {
        if (whole(0, 1) == 0) samples.erase(samples.begin() + std::ptrdiff_t(i));
    }
    return made;
}

AdmittedCurves with_gaps(CurveScene scene, RandomCurves& random) {
    for (auto& curve : scene.curves) {
        const int one_in = random.whole(1, 6);  // 1: no sample of the curve has a point
        for (auto& sample : curve.samples) {
            if (random.whole(1, one_in) == 1) sample.y = std::nan("");
        }
    }
    return admit(std::move(scene));
}

AdmittedCurves moved_by_ulps(CurveScene scene, RandomCurves& random) {
    for (auto& curve : scene.curves) {
        for (auto& [x, y] : curve.samples) {
            const int ulps = random.whole(-2, 2);
            for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps * 1e9);
        }
    }
    return admit(std::move(scene));
}

}  // namespace vidno::test
