/// Profile: how hard a run is for who does it by hand, as the decisions that are met and how much there is to write.
///
/// Met     the lines of the listing that are reached; the polygons' colours that are seen; whether two depths tie, and
///         whether a point lies on the line of an edge; of Warnock's algorithm each case of W7 to W13 with the level of
///         the quadtree at which it occurs; of the Z-buffer which polygons have pixels and lose some.
/// Counts  Warnock: the windows of each case and level, and the entries of their APLs. Z-buffer, of each polygon: rows,
///         changes of the AEL, pixels written and pixels rejected.
///
/// Two runs are equally hard if they meet the same, each count is the same but for a tenth, and the sum of all but for
/// a twentieth, both rounded up.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "choice/edition.h"
#include "vidno/picture.h"

namespace vidno {

struct Profile {
    std::set<std::string> met;
    std::map<std::string, std::uint64_t> counts;  // none is 0

    bool operator==(const Profile&) const = default;
};

struct ProfiledRun {
    Profile profile;
    Picture picture;
};

/// Runs the corrected edition; every decision is right.
ProfiledRun profiled_run(const Scene& scene, Method method);

bool is_as_hard(const Profile& profile, const Profile& as);

}  // namespace vidno
