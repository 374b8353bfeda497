#include <algorithm>
#include <utility>

#include "proof/proof.h"
#include "vidno/corrected.h"
#include "vidno/kernels/filtered.h"
#include "vidno/run.h"

namespace vidno {

namespace {

/// Proves what shows in a rectangle of pixels, as Warnock's algorithm examines a window: it leaves out the polygons
/// that do not show, and halves the rectangle if that does not decide it.
class Prover {
public:
    Prover(const AdmittedScene& scene, const std::function<void(const ProvedRectangle&)>& tell)
        : tell_(tell), picture_(scene->area, scene->background), run_(*scene, Filtered{}, NoTrace{}, picture_) {}

    Picture picture() {
        const Area& area = picture_.area();
        ProvedRectangle whole{{area.x, area.y, area.width, area.height}, {}, {}, {}};
        std::vector<Candidate> candidates;
        for (const auto& polygon : run_.polygons) {
            if (polygon.edge_on) {
                whole.edge_on.push_back(polygon.index);
            } else {
                candidates.push_back({&polygon, orientation(polygon)});
            }
        }
        prove_in(std::move(whole), std::move(candidates));
        return std::move(picture_);
    }

private:
    using OnScreen = Polygon<Filtered>;
    using Place = Point<Filtered::Coordinate>;

    /// A polygon that may show.
    struct Candidate {
        const OnScreen* polygon;
        Sign inside;         // on which side of its edges it lies
        bool holds = false;  // all centres of the rectangle
    };

    /// The first turn that is one: the polygon is convex and has an area.
    Sign orientation(const OnScreen& polygon) const {
        const auto& v = polygon.vertices;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const Sign turn = side(v[i], v[(i + 1) % v.size()], v[(i + 2) % v.size()]);
            if (turn != Sign::zero) return turn;
        }
        return Sign::zero;
    }

    Sign side(const auto& from, const auto& to, const auto& of) const {
        return run_.kernel.sign(run_.kernel.cross(from, to, of));
    }

    std::vector<Place> corner_centres(const PixelRectangle& pixels) const {
        std::vector<Place> corners;
        for (const int y : {pixels.y, pixels.y + pixels.height - 1}) {
            for (const int x : {pixels.x, pixels.x + pixels.width - 1}) {
                corners.push_back({run_.kernel.centre(x), run_.kernel.centre(y)});
            }
        }
        return corners;
    }

    /// Finds an edge that separates the corners from the polygon, or else whether the polygon holds them.
    std::optional<int> separating_edge(Candidate& candidate, const std::vector<Place>& corners) const {
        const auto& vertices = candidate.polygon->vertices;
        candidate.holds = true;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            bool is_separate = true;
            for (const Place& corner : corners) {
                const bool is_outside =
                    side(vertices[i], vertices[(i + 1) % vertices.size()], corner) == -candidate.inside;
                if (is_outside) candidate.holds = false;
                if (!is_outside) is_separate = false;
                if (!is_separate && !candidate.holds) break;
            }
            if (is_separate) return int(i);
        }
        return std::nullopt;
    }

    bool is_nearer(const OnScreen& polygon, const OnScreen& than, const Place& at) const {
        return run_.kernel.nearer(run_.kernel.depth(polygon.plane, at), run_.kernel.depth(than.plane, at), at);
    }
    /// The picture rule between two polygons that hold the place.
    bool shows_before(const OnScreen& polygon, const OnScreen& other, const Place& at) const {
        return polygon.index < other.index ? !is_nearer(other, polygon, at) : is_nearer(polygon, other, at);
    }

    void leave_out_beside(std::vector<Candidate>& candidates, const std::vector<Place>& corners,
                          ProvedRectangle& found) const {
        std::erase_if(candidates, [&](Candidate& candidate) {
            if (candidate.holds) return false;  // and so it did in the rectangle around
            const auto edge = separating_edge(candidate, corners);
            if (edge) found.beside.push_back({candidate.polygon->index, *edge});
            return edge.has_value();
        });
    }

    /// Leaves out what is behind one of the polygons that hold the rectangle: the one that shows at a corner.
    void leave_out_behind(std::vector<Candidate>& candidates, const std::vector<Place>& corners,
                          ProvedRectangle& found) const {
        const OnScreen* front = nullptr;
        for (const auto& [polygon, inside, holds] : candidates) {
            if (holds && (!front || shows_before(*polygon, *front, corners.front()))) front = polygon;
        }
        if (!front) return;
        std::erase_if(candidates, [&](const Candidate& candidate) {
            const auto hides_it = [&](const Place& corner) { return shows_before(*front, *candidate.polygon, corner); };
            const bool hidden = candidate.polygon != front && std::all_of(corners.begin(), corners.end(), hides_it);
            if (hidden) found.behind.push_back({candidate.polygon->index, front->index});
            return hidden;
        });
    }

    /// `found` is the rectangle, with what is known of it before.
    void prove_in(ProvedRectangle found, std::vector<Candidate> candidates) {
        const std::vector<Place> corners = corner_centres(found.pixels);
        leave_out_beside(candidates, corners, found);
        leave_out_behind(candidates, corners, found);
        found.is_whole = candidates.empty() || (candidates.size() == 1 && candidates.front().holds);
        if (found.is_whole && !candidates.empty()) {
            found.owner = candidates.front().polygon->index;
            picture_.paint(found.pixels, candidates.front().polygon->color);
        }
        const bool says_something = !found.edge_on.empty() || !found.beside.empty() || !found.behind.empty();
        if (found.is_whole || says_something) tell_(found);
        if (found.is_whole) return;
        const auto [x, y, width, height] = found.pixels;
        if (width >= height) {
            prove_in({{x, y, width / 2, height}, {}, {}, {}}, candidates);
            prove_in({{x + width / 2, y, width - width / 2, height}, {}, {}, {}}, std::move(candidates));
        } else {
            prove_in({{x, y, width, height / 2}, {}, {}, {}}, candidates);
            prove_in({{x, y + height / 2, width, height - height / 2}, {}, {}, {}}, std::move(candidates));
        }
    }

    const std::function<void(const ProvedRectangle&)>& tell_;
    Picture picture_;
    Run<Corrected, Filtered, NoTrace> run_;
};

}  // namespace

Picture prove(const AdmittedScene& scene, const std::function<void(const ProvedRectangle&)>& tell) {
    return Prover(scene, tell).picture();
}

}  // namespace vidno
