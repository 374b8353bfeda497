#include "grade/mistakes.h"

#include <algorithm>
#include <array>

namespace vidno {

namespace {

Scene upside_down(Scene scene) {
    for (auto& polygon : scene.polygons) {
        for (auto& v : polygon.vertices) v.y = scene.area.y + scene.area.bottom() - v.y;
    }
    return scene;
}

Scene inside_out(Scene scene) {
    for (auto& polygon : scene.polygons) {
        for (auto& v : polygon.vertices) v.z = -v.z;
    }
    return scene;
}

/// A wall in the background's colour at depth 0.
Scene walled_at_zero(Scene scene) {
    const double left = scene.area.x - 1, top = scene.area.y - 1, right = scene.area.right() + 1,
                 bottom = scene.area.bottom() + 1;
    scene.polygons.insert(
        scene.polygons.begin(),
        {"depth 0", scene.background, {{left, top, 0}, {right, top, 0}, {right, bottom, 0}, {left, bottom, 0}}});
    return scene;
}

/// A mistake that paints another scene rightly.
struct Repainting {
    UsualMistake mistake;
    Scene (*scene)(Scene);
};
constexpr std::array repaintings{Repainting{UsualMistake::y_flipped, upside_down},
                                 Repainting{UsualMistake::depth_sign_reversed, inside_out},
                                 Repainting{UsualMistake::depths_not_cleared, walled_at_zero}};

bool paints(const Scene& scene, const Picture& picture) {
    const SceneTruth truth(scene, Precision::single);
    const Area& area = scene.area;
    for (int row = area.y; row < area.bottom(); ++row) {
        for (int column = area.x; column < area.right(); ++column) {
            if (!truth.allows(column, row, picture.at(column, row))) return false;
        }
    }
    return true;
}

/// More than half, and not just one by chance.
bool most(std::size_t some, std::size_t all) { return 3 * some >= 2 * all && some > 0; }

/// By the pictures that are wrong.
std::optional<UsualMistake> by_pictures(const std::vector<Observation>& observed) {
    std::vector<const Observation*> wrong;
    for (const auto& each : observed) {
        if (each.complete && !paints(*each.scene, each.judgement->picture)) wrong.push_back(&each);
    }
    for (const auto& [mistake, scene] : repaintings) {
        const auto like = [&](const Observation* each) { return paints(scene(*each->scene), each->judgement->picture); };
        if (most(std::size_t(std::count_if(wrong.begin(), wrong.end(), like)), wrong.size())) return mistake;
    }
    return std::nullopt;
}

std::optional<UsualMistake> mistake_of(Symptom symptom) {
    switch (symptom) {
        case Symptom::overlooked: return UsualMistake::one_list;
        case Symptom::start: return UsualMistake::depths_not_cleared;
        case Symptom::clipped_away:
        case Symptom::clipped_inside: return UsualMistake::clip_order_reversed;
        case Symptom::off_window: return UsualMistake::y_flipped;
        case Symptom::comparison: return UsualMistake::depth_sign_reversed;
        case Symptom::hole: return UsualMistake::boundary_outside;
        case Symptom::parts_missing: return UsualMistake::integer_division;
        case Symptom::surrounded: return UsualMistake::surround_kept;
        default: return std::nullopt;
    }
}

/// By the kinds of steps that are wrong.
std::optional<UsualMistake> by_steps(const std::vector<Observation>& observed) {
    std::array<std::size_t, std::size_t(UsualMistake::surround_kept) + 1> votes{};
    std::size_t wrong = 0;
    for (const auto& each : observed) {
        if (!each.judgement->wrong) continue;
        ++wrong;
        if (const auto mistake = mistake_of(each.judgement->wrong->symptom)) ++votes[std::size_t(*mistake)];
    }
    const auto best = std::max_element(votes.begin(), votes.end());
    if (!most(*best, wrong)) return std::nullopt;
    return UsualMistake(best - votes.begin());
}

}  // namespace

std::string_view words_of(UsualMistake mistake) {
    switch (mistake) {
        case UsualMistake::one_list:
            return "one APL is shared by all parts of a window: what leaves it in one part is gone in the others. Give each "
                   "part a copy";
        case UsualMistake::depths_not_cleared:
            return "the depths are not cleared: they start at 0, and what lies behind that never shows. Start below all depths";
        case UsualMistake::clip_order_reversed:
            return "the sides of the window are gone round the other way when clipping, so that inside and outside are "
                   "exchanged. Turn the order of its corners or the sign round";
        case UsualMistake::y_flipped:
            return "the picture is upside down: y grows downward, row 0 is the uppermost";
        case UsualMistake::depth_sign_reversed:
            return "the sign of z is reversed: the greater z is the nearer";
        case UsualMistake::boundary_outside:
            return "points on an outline count as outside of both polygons that share it: pixels there belong to nobody. Let a "
                   "product of 0 count as inside, or give such points to one of the two";
        case UsualMistake::integer_division:
            return "a window is halved in whole numbers: of an odd number of pixels one is lost. Begin with a square of 2^m "
                   "pixels a side that covers the area";
        case UsualMistake::surround_kept:
            return "hasSurround is never reset: a polygon that lies before the surrounding one in a part of the window is "
                   "overlooked. Set it to false wherever a nearer polygon is found";
    }
    return "";
}

std::optional<UsualMistake> usual_mistake(const std::vector<Observation>& observed) {
    const auto mistake = by_pictures(observed);
    return mistake ? mistake : by_steps(observed);
}

}  // namespace vidno
