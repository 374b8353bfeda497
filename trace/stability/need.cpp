#include "stability/need.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "json/json_text.h"
#include "run/run.h"
#include "scene/exact_scene.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

/// The first wrong pixel of a picture.
std::optional<std::string> wrong_pixel(const Picture& picture, const Picture& right) {
    const Area& area = right.area();
    for (int y = area.y; y < area.bottom(); ++y) {
        for (int x = area.x; x < area.right(); ++x) {
            if (picture.at(x, y) == right.at(x, y)) continue;
            return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " + hex_of(picture.at(x, y)) +
                   ", not " + hex_of(right.at(x, y));
        }
    }
    return std::nullopt;
}

/// Goes down from the highest level while the picture stays right.
struct Knob {
    int needed;             // the lowest level with the right picture
    std::string one_lower;  // the wrong pixel below that; empty if there is nothing below
};
Knob turned_down(int most, int least, const auto& picture_at, const Picture& right) {
    for (int value = most; value > least; --value) {
        if (const auto wrong = wrong_pixel(picture_at(value - 1), right)) return {value, *wrong};
    }
    return {least, ""};
}

std::string of(std::size_t needed, std::size_t all) { return std::to_string(needed) + " of " + std::to_string(all); }

std::string with(const std::string& fewer, const std::string& wrong) {
    return wrong.empty() ? "" : "with " + fewer + " " + wrong;
}

class Needs {
public:
    Needs(const AdmittedScene& scene, const std::function<void()>& progress)
        : scene_(scene), progress_(progress), right_(right_picture(scene)), least_(scene) {}

    NeedReport report() {
        const auto keeps = [&](const AdmittedScene& candidate) { return right_picture(candidate) == right_; };
        least_ = with_fewest_parts(scene_, keeps);
        tell("polygons", of(least_->polygons.size(), scene_->polygons.size()), missed_polygon());
        tell("vertices", of(vertices_of(least_), vertices_of(scene_)), missed_vertex());
        places();
        arithmetic();
        levels();
        return {std::move(needs_), std::move(least_)};
    }

private:
    Picture right_picture(const AdmittedScene& scene) const {
        progress_();
        return run({Method::zbuffer, filtered_, Edition::corrected, scene});
    }

    void tell(std::string what, std::string amount, std::string one_lower) {
        needs_.push_back({std::move(what), std::move(amount), std::move(one_lower)});
    }

    std::string missed_polygon() const {
        if (least_->polygons.empty()) return "";
        const auto wrong = wrong_pixel(right_picture(without_polygon(least_, 0)), right_);
        return "without \"" + least_->polygons[0].id + "\" " + *wrong;
    }

    /// Triangles cannot lose a vertex, and the rest of a polygon may not be admitted.
    std::string missed_vertex() const {
        for (std::size_t polygon = 0; polygon < least_->polygons.size(); ++polygon) {
            for (std::size_t vertex = 0; vertex < least_->polygons[polygon].vertices.size(); ++vertex) {
                const auto fewer = without_vertex(least_, polygon, vertex);
                if (!fewer) continue;
                return "without vertex " + std::to_string(vertex) + " of \"" + least_->polygons[polygon].id + "\" " +
                       *wrong_pixel(right_picture(*fewer), right_);
            }
        }
        return "";
    }

    /// The bits of coordinates, which are snapped. Polygons that would not stay planar or convex are first cut into
    /// triangles.
    void places() {
        Resolution finest{0, 0};
        for (const auto& polygon : least_->polygons) {
            for (const auto& v : polygon.vertices) {
                finest.xy = std::max({finest.xy, binary_places(v.x), binary_places(v.y)});
                finest.z = std::max(finest.z, binary_places(v.z));
            }
        }
        const auto tell_places = [&](const std::string& what, int most, const auto& resolution) {
            const auto picture_at = [&](int value) {
                return right_picture(exact_scene::snapped(least_, resolution(value)));
            };
            const Knob knob = turned_down(most, 0, picture_at, right_);
            tell(what, of(std::size_t(knob.needed), std::size_t(most)),
                 with(std::to_string(knob.needed - 1), knob.one_lower));
        };
        tell_places("binary places of x and y", finest.xy, [](int value) { return Resolution{value, every_place}; });
        tell_places("binary places of z", finest.z, [](int value) { return Resolution{every_place, value}; });
    }

    /// The bits of the significand: `bits:P` or, if 24 are not enough, the 53 of `double`.
    void arithmetic() {
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            const std::string what = "bits of arithmetic, " + std::string(method_names[std::size_t(method)]);
            const auto picture_under = [&](const std::string& kernel) {
                progress_();
                return run({method, *kernel_named(kernel), Edition::corrected, least_});
            };
            const auto picture_at = [&](int bits) { return picture_under("bits:" + std::to_string(bits)); };
            const auto wrong_in_double = wrong_pixel(picture_under("double"), right_);
            const auto wrong_at_most = wrong_pixel(picture_at(most_bits), right_);
            if (wrong_in_double) {
                tell(what, "more than 53", with("double", *wrong_in_double));
            } else if (wrong_at_most) {
                tell(what, "53", with("24", *wrong_at_most));
            } else {
                const Knob knob = turned_down(most_bits, fewest_bits, picture_at, right_);
                tell(what, std::to_string(knob.needed), with(std::to_string(knob.needed - 1), knob.one_lower));
            }
        }
    }

    /// The levels of Warnock's windows: at the last level a window gets the colour of its centre.
    void levels() {
        const int most = std::countr_zero(unsigned(covering_square(scene_->area).width));
        const auto picture_at = [&](int level) {
            progress_();
            RunRequest request{Method::warnock, filtered_, Edition::corrected, least_};
            request.smallest_window = std::ldexp(1, most - level);
            return run(request);
        };
        const Knob knob = turned_down(most, 0, picture_at, right_);
        tell("levels of subdivision", of(std::size_t(knob.needed), std::size_t(most)),
             with(std::to_string(knob.needed - 1), knob.one_lower));
    }

    const NamedKernel filtered_ = kernel_of(KernelKind::filtered);
    const AdmittedScene& scene_;
    const std::function<void()>& progress_;
    Picture right_;
    AdmittedScene least_;
    std::vector<Need> needs_;
};

}  // namespace

NeedReport needs_of(const AdmittedScene& scene, const std::function<void()>& progress) {
    return Needs(scene, progress).report();
}

}  // namespace vidno
