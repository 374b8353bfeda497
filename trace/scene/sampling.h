/// Sampling: a surface y = f(x, z) as curves z = const, seen in parallel, with their samples on whole columns.
#pragma once

#include <optional>
#include <vector>

#include "scene/height_function.h"
#include "vidno/floating_horizon/curves.h"

namespace vidno {

/// A vector on the screen, in pixels: whole ones to the right, and downward.
struct ScreenWay {
    int columns = 0;
    double rows = 0;
};

/// The view: any parallel projection in which a curve goes from left to right.
struct SurfaceView {
    ScreenWay origin;  // the place of the nearest curve's left end, if y were 0
    ScreenWay across;  // from a curve's left end to its right one; at least a column
    ScreenWay back;    // from a curve to the next, farther one
    double up = 1;     // pixels upward for one of y
};

struct FunctionSurface {
    HeightFunction function;
    double left = 0, right = 1;        // x at the curves' ends
    double nearest = 1, farthest = 0;  // z of the first curve and of the last
    int curves = 2;                    // at least 2
    int samples = 2;  // of each curve, evenly spaced except for rounding to columns; 2 <= samples <= columns across + 1
    std::optional<double> tolerance;  // pixels: see sampled
    SurfaceView view;
};

/// The surface with a sample on each column: everything that the screen can show of the function.
FunctionSurface on_each_column(FunctionSurface surface);

/// The curves, the nearest first. Where the function is not finite, or too large to be shown, a sample has no point.
///
/// With a tolerance there are more samples where a curve needs them: while the curve is farther than the tolerance from
/// the line between two samples over any column, or begins or ends between them, one more is put halfway. Every column
/// between is examined, so that no peak or gap as wide as a column is missed. At worst there is a sample on each
/// column.
std::vector<Curve> sampled(const FunctionSurface& surface);

}  // namespace vidno
