#include "find/lattice_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stability/shrink.h"
#include "vidno/resolution.h"

namespace vidno {

namespace {

constexpr int fewest_columns = 2;

int index_in(RandomPolygons& random, const auto& list) { return random.whole(0, int(list.size()) - 1); }

/// Draws curves, and changes one thing of a scene.
class CurveChange {
public:
    CurveChange(CurveScene& scene, RandomPolygons& random, const Lattice& lattice)
        : scene_(scene), random_(random), lattice_(lattice), unit_(std::ldexp(1.0, -random.whole(0, lattice.places))) {}

    void one() {
        switch (random_.whole(0, 11)) {
            case 0:
            case 1:
            case 2: {
                one_sample().y += (random_.whole(0, 1) * 2 - 1) * random_.whole(1, 2) * unit_;
                return;
            }
            case 3: {
                one_sample().y = height();
                return;
            }
            case 4: return add();
            case 5: return remove();
            case 6: return std::swap(one_curve(), one_curve());
            case 7: return meet();
            case 8: return remove_sample();
            case 9: return shift();
            case 10: return resize();
            default: return towards_zero();
        }
    }

    void add() {
        if (scene_.curves.size() < std::size_t(lattice_.most_polygons)) scene_.curves.push_back(drawn());
    }

private:
    Curve& one_curve() { return scene_.curves[std::size_t(index_in(random_, scene_.curves))]; }
    Sample& one_sample() {
        auto& samples = one_curve().samples;
        return samples[std::size_t(index_in(random_, samples))];
    }

    double height() {
        if (lattice_.greatest > 0) return random_.whole(-lattice_.greatest, lattice_.greatest) * unit_;
        const int steps = int(1 / unit_);
        return random_.whole(-steps, (scene_.area.height + 1) * steps) * unit_;
    }

    /// Over all columns, or at both ends alone, or at some columns; rarely with a gap.
    Curve drawn() {
        const int width = scene_.area.width;
        if (!scene_.curves.empty() && random_.whole(0, 3) == 0) return one_curve();
        const int first = random_.whole(0, 3) == 0 ? random_.whole(0, width - fewest_columns) : 0;
        const int last = random_.whole(0, 3) == 0 ? random_.whole(first + 1, width - 1) : width - 1;
        const int most_apart = random_.whole(0, 1) == 0 ? 1 : width;
        Curve curve;
        for (int x = first; x < last; x += random_.whole(1, most_apart)) curve.samples.push_back({x, height()});
        curve.samples.push_back({last, height()});
        if (curve.samples.size() > 3 && random_.whole(0, 7) == 0) {
            curve.samples[1].y = std::numeric_limits<double>::quiet_NaN();
        }
        return curve;
    }

    void remove() { scene_.curves.erase(scene_.curves.begin() + index_in(random_, scene_.curves)); }

    /// A sample takes the height of another at its column.
    void meet() {
        Sample& sample = one_sample();
        for (const Sample& other : one_curve().samples) {
            if (other.x == sample.x) sample.y = other.y;
        }
    }

    void remove_sample() {
        auto& samples = one_curve().samples;
        if (samples.size() > 2) samples.erase(samples.begin() + index_in(random_, samples));
    }

    void shift() {
        const double by = (random_.whole(0, 1) * 2 - 1) * unit_;
        for (Sample& sample : one_curve().samples) sample.y += by;
    }

    /// Curves lose the samples that a narrower area has no columns for.
    void resize() {
        Area& area = scene_.area;
        int& side = random_.whole(0, 1) == 0 ? area.width : area.height;
        side = std::clamp(side + random_.whole(0, 1) * 2 - 1, &side == &area.width ? fewest_columns : 1,
                          std::max(lattice_.widest, fewest_columns));
        for (Curve& curve : scene_.curves) {
            std::erase_if(curve.samples, [&](const Sample& sample) { return sample.x >= area.width; });
        }
        std::erase_if(scene_.curves, [](const Curve& curve) { return curve.samples.size() < 2; });
    }

    void towards_zero() {
        Sample& sample = one_sample();
        if (!sample.has_point()) return;
        sample.y = snapped(sample.y, std::max(0, binary_places(sample.y) - random_.whole(1, 3)));
    }

    CurveScene& scene_;
    RandomPolygons& random_;
    const Lattice& lattice_;
    double unit_;
};

std::optional<AdmittedCurves> admitted_or_none(CurveScene scene) {
    if (scene.curves.empty()) return std::nullopt;
    return admit(std::move(scene));
}

}  // namespace

std::optional<AdmittedCurves> lattice_curves(RandomPolygons& random, const Lattice& lattice) {
    if (!lattice.is_coarse && random.whole(0, 3) == 0) {
        return admit(curve_families[std::size_t(index_in(random, curve_families))].curves(random));
    }
    CurveScene scene;
    scene.area.width = random.whole(fewest_columns, std::max(lattice.widest, fewest_columns));
    scene.area.height = random.whole(0, 3) == 0 ? random.whole(1, lattice.widest) : scene.area.width;
    CurveChange change(scene, random, lattice);
    for (int count = random.whole(1, lattice.most_polygons); count > 0; --count) change.add();
    return admitted_or_none(std::move(scene));
}

std::optional<AdmittedCurves> changed_scene(CurveScene scene, RandomPolygons& random, const Lattice& lattice) {
    if (!lattice.is_coarse && random.whole(0, 15) == 0) {
        return moved_by_ulps(std::move(scene), random.whole(1, 4), random);
    }
    for (int changes = 1 + random.whole(0, 3) * random.whole(0, 1); changes > 0 && !scene.curves.empty(); --changes) {
        CurveChange(scene, random, lattice).one();
    }
    return admitted_or_none(std::move(scene));
}

}  // namespace vidno
