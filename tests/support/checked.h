/// The findings on a run, for tests.
#pragma once

#include <string_view>
#include <vector>

#include "check/check.h"
#include "check/findings.h"
#include "choice/method.h"

namespace vidno::test {

/// The findings on a run, and the rest of the report of `vidno check`.
struct Checked {
    std::vector<Finding> findings;
    CheckReport report;
};

inline Checked checked(const AdmittedScene& scene, Method method, std::string_view kernel, std::size_t narrowest = 20) {
    FindingList list(choice_of(method).procedure, scene->area, narrowest);
    const RunRequest request{method, *kernel_named(kernel), Edition::corrected, scene};
    CheckReport report = check_run(
        request, right_picture(scene, method), [](const auto&) {}, &list);
    return {list.findings(), std::move(report)};
}

inline std::vector<Finding> of_kind(const Checked& checked, FindingKind kind) {
    std::vector<Finding> found;
    for (const auto& each : checked.findings) {
        if (each.kind == kind) found.push_back(each);
    }
    return found;
}

}  // namespace vidno::test
