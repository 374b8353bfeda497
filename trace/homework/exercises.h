/// Exercises: scenes as hard as a given one, with other numbers, one for each student.
///
/// Takes   a scene that can be worked by hand (by_hand), the method by which its profile (profile.h) is taken,
///         how many exercises are wanted, and a seed.
/// Gives   scenes with the same area, polygons, ids, colours and numbers of vertices, each polygon on the lattice of
///         its own original: no coordinate needs more binary places than its polygon had. They are exactly planar,
///         reach no farther than the original, and are equally hard. All slopes and depths that the run computes are
///         short (is_short), or, where the search finds no such scene, no more of them are long than in the original.
///         The pictures of any two, the original included, differ in more than one pixel in 32, however either is
///         mirrored or rotated. There may be fewer than requested if the search finds no more.
/// How     a walk from the original, a small change a step: a polygon is shifted, raised, mirrored or turned in place,
///         a vertex or an edge of it is moved, or it is tilted with all polygons in its plane. A step that would make
///         the run harder or easier, or add long numbers, is not taken. Now and then the whole scene, mirrored or
///         turned, is an exercise.
/// Equal arguments give equal scenes on every machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "choice/edition.h"
#include "vidno/admitted.h"

namespace vidno {

inline constexpr std::size_t most_exercises = 1000;

struct ByHand {
    AdmittedScene scene;
    std::string note;  // how it was rounded; empty if it is as given
};

/// The scene if it can be worked by hand: with coordinates of few binary places, and exactly planar. Otherwise the
/// scene with its coordinates rounded to the coarsest lattice that leaves the picture of the method as it is. Throws
/// Refused if there is none, and for a scene without polygons.
ByHand by_hand(const AdmittedScene& scene, Method method, const std::string& file);

/// `progress` hears the number of exercises so far, at each attempt.
std::vector<AdmittedScene> exercises_of(const AdmittedScene& scene, Method method, std::size_t count,
                                        std::uint64_t seed, const std::function<void(std::size_t)>& progress);

}  // namespace vidno
