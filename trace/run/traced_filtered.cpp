#include "run/told_set.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture told_filtered(const RunRequest& request, const StageCount* count) {
    return told(request, FilteredBy(StageTally{count}));
}

}  // namespace vidno
