#include "run/traced_set.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture traced_filtered(const RunRequest& request, const StageCount* count) {
    return traced(request, FilteredBy(StageTally{count}));
}

}  // namespace vidno
