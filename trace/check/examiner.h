/// Examiner: the operations of a run, and its errors in single steps and in the picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "check/check.h"
#include "check/visible_areas.h"
#include "loss.h"

namespace vidno {

/// The elementary steps of the listings.
enum class Operation : unsigned char { windows, boxes, depths, orientations, comparisons, intersections, rows, edges };
inline constexpr std::array<std::string_view, 8> operation_names{
    "windows", "boxes", "depths", "orientations", "comparisons", "intersections", "rows", "edges"};
using OperationCounts = std::array<std::uint64_t, operation_names.size()>;

struct Findings {
    bool complete = true;         // no fault ended the run
    std::vector<Color> pixels{};  // of the picture, row by row from the top
    std::vector<Loss> losses;     // of the run
    OperationCounts operations{};
    std::uint64_t wrong_pixels = 0;
    double area = 0;  // shown in a wrong colour, in pixels
    std::uint64_t decisions = 0, wrong_decisions = 0;
    double depth_ulps = 0;  // the error of the worst depth; infinite for NaN
};

/// The truth about a scene, with which runs of it are compared.
class Examiner {
public:
    explicit Examiner(const AdmittedScene& scene);
    ~Examiner();
    Examiner(const Examiner&) = delete;
    Examiner& operator=(const Examiner&) = delete;

    /// `sources`: for each polygon of the request's scene, the corresponding one of the examiner's scene.
    Findings examine(const RunRequest& request, const std::vector<std::size_t>& sources) const;

    const Picture& right() const { return right_; }

    /// How much even the right picture shows in a wrong colour, in pixels, since a pixel has only one colour.
    double area_of_pixels() const { return visible_.wrong_in(right_); }

    /// How many pixels differ in any of some trials, in each of which every coordinate is moved by up to one ulp.
    std::size_t unsteady_pixels() const;

private:
    class Depths;

    const AdmittedScene& scene_;
    Picture right_;
    VisibleAreas visible_;
    std::unique_ptr<const Depths> depths_;
};

}  // namespace vidno
