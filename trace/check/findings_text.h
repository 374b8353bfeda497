/// Findings as text: lines of JSON, `vidno-decisions/1`, or CSV.
#pragma once

#include <string>
#include <vector>

#include "check/findings.h"
#include "run/floating_horizon_run.h"

namespace vidno {

/// The run that the findings belong to.
struct FindingsHeader {
    std::string_view method;
    std::string edition;
    std::string kernel, scene;
    std::vector<std::string> polygons;  // their ids; none of curves
};

FindingsHeader findings_header(const RunRequest& request);
FindingsHeader findings_header(const FloatingHorizonRequest& request, const std::string& name);

/// A line that describes the run, and a line for each finding.
std::string findings_jsonl(const FindingsHeader& header, const std::vector<Finding>& findings);

/// A line of titles, and a line for each finding.
std::string findings_csv(const FindingsHeader& header, const std::vector<Finding>& findings);

}  // namespace vidno
