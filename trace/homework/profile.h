/// Profile: how hard a run is to work by hand, measured by the cases that occur and the amount of writing.
///
/// Met     the lines of the listing that are reached; the polygons' colours that are seen; whether two depths tie, and
///         whether a point lies on the line of an edge; for Warnock's algorithm, each case of W7 to W13 with the level
///         of the quadtree at which it occurs; for the Z-buffer, the polygons that have pixels and those that lose
///         some.
/// Counts  Warnock: the windows of each case and level, and the entries of their APLs. Z-buffer, for each polygon:
///         rows, changes of the AEL, pixels written and pixels rejected.
///
/// Long    how many of the slopes and depths that are written down are long (is_short).
///
/// Two runs are equally hard if they meet the same cases, each count differs by at most a tenth, and the sum of all
/// counts by at most a twentieth, both rounded up.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "choice/edition.h"
#include "vidno/admitted.h"
#include "vidno/picture.h"

namespace vidno {

struct Profile {
    std::set<std::string> met;
    std::map<std::string, std::uint64_t> counts;  // never 0

    bool operator==(const Profile&) const = default;
};

struct ProfiledRun {
    Profile profile;
    Picture picture;
    std::uint64_t long_numbers;
};

/// Whether a number of a run is a fraction of two whole numbers with at most two digits each. Takes its approximation
/// in `double`.
bool is_short(double number);

/// Runs the corrected edition; every decision is right.
ProfiledRun profiled_run(const AdmittedScene& scene, Method method);

bool is_as_hard(const Profile& profile, const Profile& as);

}  // namespace vidno
