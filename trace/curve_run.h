/// Running the floating horizon as chosen at run time: told to a trace or not, its decisions held against the truth or not.
#pragma once

#include "curve_trace.h"
#include "decision_count.h"
#include "run.h"

namespace vidno {

struct CurveRequest {
    NamedKernel kernel;  // one that runs curves, in this edition
    Edition edition;
    const CurveScene& scene;
    Detail detail = Detail::windows;
    TraceWriter* writer = nullptr;           // none: no trace
    std::function<void()> progress = [] {};  // without a trace, called at each curve; checked, at each step
};

/// Throws EventLimitReached out of the writer.
DrawnLines run(const CurveRequest& request);

/// Of each curve, over which of its columns it is drawn.
using ColumnsDrawn = std::vector<std::vector<bool>>;
ColumnsDrawn columns_drawn(const DrawnLines& lines, const CurveScene& scene);

/// Of the same curves, over how many columns one is drawn and the other not.
std::uint64_t different_columns(const ColumnsDrawn& one, const ColumnsDrawn& other);

struct CurveCheckReport : DecisionReport {
    DrawnLines lines;
    /// Of the columns of all curves, and of these those over which a curve is drawn though it is hidden, or the other way round.
    std::uint64_t columns = 0, wrong_columns = 0;

    bool found_something() const { return wrong_columns > 0 || any_wrong(); }
};

/// Runs the curves with every decision of Visibility, and under `float`, `double` and `bits` every comparison, held against
/// the exact one along the path that was taken; the lines, against those of the corrected procedures in exact arithmetic.
/// `hear` is told of each event of level `signs`.
CurveCheckReport check_run(
    const CurveRequest& request, const std::function<void(const Event&)>& hear = [](const Event&) {});

/// Traces a run to the end of its file, checked or not; false if the writer's limit ended it, so that it is partial.
bool write_trace(CurveRequest request, TraceWriter& writer, bool checked);

}  // namespace vidno
