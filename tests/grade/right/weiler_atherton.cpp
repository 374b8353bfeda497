// Weiler and Atherton's algorithm with convex pieces: the part of a piece outside another is cut into convex pieces.
// Polygons that pierce each other are split when one clips the other. The calls of `trace` report the steps to vidno.
//
//     weiler_atherton [windows | polygons | signs]     writes weiler_atherton.jsonl
#include "../course.h"

using Convex = std::vector<Point>;  // runs clockwise on the screen

/// A convex piece of a polygon.
struct Part {
    int polygon;
    Convex outline;
    bool ground;
};

double twice_area(const Convex& outline) {
    double sum = 0;
    for (std::size_t i = 2; i < outline.size(); ++i) sum += cross(outline[0], outline[i - 1], outline[i]);
    return sum;
}

/// Areas below this are gaps that rounding leaves between pieces.
const double least_area = 1e-9;

/// The outline without vertices that are as good as the one before: the line through two such vertices could have any
/// direction.
Convex without_repeats(const Convex& outline) {
    Convex kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        if (std::abs(p.x - q.x) + std::abs(p.y - q.y) > least_area) kept.push_back(p);
    }
    return kept;
}

/// The part of an outline where `value`, a linear function of a point, is not negative; empty if it has no area.
template <class Value>
Convex half_of(const Convex& outline, const Value& value) {
    Convex kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        const double vp = value(p), vq = value(q);
        if (vp >= 0) kept.push_back(p);
        if ((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
            const double t = vp / (vp - vq);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t});
        }
    }
    kept = without_repeats(kept);
    return twice_area(kept) < least_area ? Convex{} : kept;
}

class WeilerAtherton {
public:
    WeilerAtherton(const Scene& scene, WeilerAthertonTrace& trace) : scene_(scene), trace_(trace) {
        std::vector<Part> parts;
        for (int i = 0; i < int(scene.polygons.size()); ++i) {
            if (is_edge_on(scene.polygons[std::size_t(i)])) continue;
            const Convex part = part_in_area(scene.polygons[std::size_t(i)]);
            trace.cut_to_area(i, region_of(part));
            if (!part.empty()) parts.push_back({i, part, false});
        }
        const auto nearer = [this](const Part& a, const Part& b) { return greatest_depth(a) > greatest_depth(b); };
        std::stable_sort(parts.begin(), parts.end(), nearer);
        push(parts);
        while (!lists_.empty()) {
            const std::vector<Part> list = lists_.back();
            lists_.pop_back();
            trace.pop_list();
            process(list);
        }
    }

private:
    static Region region_of(const Convex& outline) {
        if (outline.empty()) return {};
        Region region(1);
        for (const Point& p : outline) region[0].push_back({p.x, p.y});
        return region;
    }

    Convex part_in_area(const Polygon& polygon) const {
        Convex outline;
        for (const Vertex& v : polygon.vertices) outline.push_back({v.x, v.y});
        if (twice_area(outline) < 0) std::reverse(outline.begin(), outline.end());
        const Area& area = scene_.area;
        outline = half_of(outline, [&](Point p) { return p.x - area.x; });
        outline = half_of(outline, [&](Point p) { return area.x + area.width - p.x; });
        outline = half_of(outline, [&](Point p) { return p.y - area.y; });
        return half_of(outline, [&](Point p) { return area.y + area.height - p.y; });
    }

    double depth_of(int polygon, Point p) const { return depth(scene_.polygons[std::size_t(polygon)], p); }

    double greatest_depth(const Part& part) const {
        double greatest = depth_of(part.polygon, part.outline[0]);
        for (const Point& p : part.outline) greatest = std::max(greatest, depth_of(part.polygon, p));
        return greatest;
    }

    void push(const std::vector<Part>& parts) {
        if (parts.empty()) return;
        lists_.push_back(parts);
        std::vector<Piece> reported;
        for (const Part& part : parts) reported.push_back({part.polygon, region_of(part.outline), part.ground});
        trace_.push_list(reported);
    }

    /// The first piece of the list clips the others.
    void process(const std::vector<Part>& list) {
        const Part& clip = list[0];
        std::vector<Part> inside, outside;
        for (std::size_t i = 1; i < list.size(); ++i) {
            const Part& part = list[i];
            Convex rest = part.outline;
            Region out;
            for (std::size_t j = 0; j < clip.outline.size() && !rest.empty(); ++j) {
                const Point from = clip.outline[j], to = clip.outline[(j + 1) % clip.outline.size()];
                const Convex beyond = half_of(rest, [&](Point p) { return cross(from, p, to); });
                if (!beyond.empty()) {
                    outside.push_back({part.polygon, beyond, part.ground});
                    out.push_back(region_of(beyond)[0]);
                }
                rest = half_of(rest, [&](Point p) { return cross(from, to, p); });
            }
            if (!rest.empty()) inside.push_back({part.polygon, rest, part.ground});
            trace_.clipped(part.polygon, region_of(rest), out);
        }
        push(outside);
        show_or_push(clip, nearer_ones(clip, inside));
    }

    /// The parts of the pieces inside that are nearer than the clip piece.
    std::vector<Part> nearer_ones(const Part& clip, const std::vector<Part>& inside) {
        std::vector<Part> nearer;
        std::vector<int> polygons;
        for (const Part& part : inside) {
            if (part.ground) continue;
            const Convex before = nearer_part(part, clip.polygon);
            const Point place = before.empty() ? centre_of(part.outline) : centre_of(before);
            trace_.behind(part.polygon, place.x, place.y, depth_of(part.polygon, place), depth_of(clip.polygon, place),
                          before.empty());
            if (before.empty()) continue;
            nearer.push_back({part.polygon, before, false});
            polygons.push_back(part.polygon);
        }
        trace_.nearer_ones(polygons);
        return nearer;
    }

    void show_or_push(Part clip, std::vector<Part> nearer) {
        if (nearer.empty()) return trace_.show(clip.polygon, region_of(clip.outline));
        clip.ground = true;
        nearer.push_back(clip);
        push(nearer);
    }

    /// Where a piece is nearer than a polygon. In one plane the first polygon of the scene is the nearer one.
    Convex nearer_part(const Part& part, int than) const {
        const auto before = [&](Point p) { return depth_of(part.polygon, p) - depth_of(than, p); };
        double most = 0;
        for (const Point& p : part.outline) most = std::max(most, std::abs(before(p)));
        if (most < 1e-12) return part.polygon < than ? part.outline : Convex{};
        return half_of(part.outline, before);
    }

    static Point centre_of(const Convex& outline) {
        Point sum{0, 0};
        for (const Point& p : outline) sum = {sum.x + p.x, sum.y + p.y};
        return {sum.x / double(outline.size()), sum.y / double(outline.size())};
    }

    const Scene& scene_;
    WeilerAthertonTrace& trace_;
    std::vector<std::vector<Part>> lists_;
};

int main(int count, char** words) {
    const Scene scene = scene_to_draw(example_scene());
    WeilerAthertonTrace trace("weiler_atherton.jsonl", scene, detail_from(count, words));
    WeilerAtherton(scene, trace);
}
