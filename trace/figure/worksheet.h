/// Worksheet: a scene on pages of A4, with tables to be filled in by hand, and the same pages filled in.
///
/// Warnock: scene and planes; quadtree; the windows with the APL, in the family with the relations. Z-buffer: scene and
/// planes; the rows with the AEL; the picture with its depths. Weiler-Atherton: scene and planes; the visible regions;
/// the lists. Floating horizon: samples and a grid; for each curve, heights, flags and horizons over the columns.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "drawing.h"
#include "figure_words.h"
#include "worked_curves.h"
#include "worked_run.h"

namespace vidno::figures {

/// Refuses a scene that is too large for the pages.
void expect_room(const Scene& scene, const std::string& file);
void expect_room(const CurveScene& scene, const std::string& file);

/// The rows of the table that a sheet has, or for curves the curves: those with these numbers, from 1, or those that
/// begin at these steps.
struct ChosenRows {
    std::uint64_t first = 1, last = std::numeric_limits<std::uint64_t>::max();
    bool are_steps = false;
};

/// The pages, in millimetres. Blank and answered ones differ only in the answers. With chosen rows the table has no
/// others, but the row before them is filled in, and so is where each row is. Throws Refused if there are no such rows.
std::vector<Drawing> worksheet(const WorkedRun& run, Language language, bool answered,
                               const std::optional<ChosenRows>& chosen = {});
std::vector<Drawing> worksheet(const WorkedCurves& run, Language language, bool answered,
                               const std::optional<ChosenRows>& chosen = {});

}  // namespace vidno::figures
