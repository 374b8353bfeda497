/// Random curves for tests of the floating horizon.
#pragma once

#include <random>

#include "curves.h"

namespace vidno::test {

/// Makes scenes of curves with many coincidences: few different heights, equal curves, samples on other curves, peaks.
class RandomCurves {
public:
    explicit RandomCurves(unsigned seed) : random_(seed) {}

    int whole(int low, int high) { return low + int(random_() % unsigned(high - low + 1)); }

    AdmittedCurves scene();

private:
    Curve curve(const Area& area, int kind);
    double height(int kind);
    Curve variant(Curve made);

    std::mt19937 random_;
};

/// Random curves without the points of some samples: curves with gaps at their ends and within, of one piece, several
/// or none.
AdmittedCurves with_gaps(CurveScene scene, RandomCurves& random);

/// Moves each height by up to two ulps, so coincidences become near misses.
AdmittedCurves moved_by_ulps(CurveScene scene, RandomCurves& random);

}  // namespace vidno::test
