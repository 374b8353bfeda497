/// Worksheet: a scene on pages of A4, with tables to be filled in by hand, and the same pages filled in.
///
/// Warnock: scene and planes; quadtree; the windows with the APL. Z-buffer: scene and planes; the rows with the AEL;
/// the picture with its depths.
#pragma once

#include <vector>

#include "drawing.h"
#include "figure_words.h"
#include "worked_run.h"

namespace vidno::figures {

/// Refuses a scene that is too large for the pages.
void expect_room(const Scene& scene, const std::string& file);

/// The pages, in millimetres. Blank and answered ones differ only in the answers.
std::vector<Drawing> worksheet(const WorkedRun& run, Language language, bool answered);

}  // namespace vidno::figures
