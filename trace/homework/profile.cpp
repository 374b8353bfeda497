#include "homework/profile.h"

#include <cmath>

#include "run/run.h"

namespace vidno {

namespace {

/// The sink that builds the profile. Repeated events are counted under one name.
class Profiler final : public EventSink {
public:
    explicit Profiler(const Scene& scene) : scene_(scene) {}

    void hear(const EventView& event) override {
        event.visit([this](const auto& e) {
            lines_.insert(e.at);
            note(e);
        });
    }

    std::uint64_t long_numbers() const { return long_numbers_; }

    Profile profile(const Picture& picture) const {
        Profile profile{{}, counts_};
        for (const Line line : lines_) profile.met.insert("line " + std::string(line_names[std::size_t(line)]));
        for (const ScenePolygon& polygon : scene_.polygons) {
            const auto& pixels = picture.pixels();
            if (std::find(pixels.begin(), pixels.end(), polygon.color) != pixels.end()) {
                profile.met.insert("colour of " + polygon.id);
            }
        }
        if (on_a_line_) profile.met.insert("point on a line");
        if (ties_) profile.met.insert("tie");
        return profile;
    }

private:
    void note(const event::Pop& e) {
        if (root_side_ == 0) root_side_ = e.window.width;
        level_ = std::ilogb(root_side_ / std::max(e.window.width, e.window.height));
    }
    void note(const event::Decide& e) {
        ++counts_[std::string(case_names[std::size_t(e.which)]) + " at level " + std::to_string(level_)];
    }
    void note(const event::Count&) { ++counts_["entries of APLs"]; }
    void note(const event::Orient& e) { on_a_line_ = on_a_line_ || e.sign == Sign::zero; }
    void note(const event::Compare& e) { note_tie(e.z, e.against); }
    void note(const event::Depth& e) { note_written(e.z); }

    void note(const event::Polygon& e) { polygon_ = scene_.polygons[std::size_t(e.polygon.index)].id; }
    void note(const event::Scanline&) { ++counts_["rows of " + polygon_]; }
    void note(const event::AelAdd& e) {
        note_change();
        for (const Value& value : {e.z, e.dx, e.dz}) note_written(value);
    }
    void note(const event::AelStep& e) {
        note_change();
        note_written(e.z);
    }
    void note(const event::Slope& e) { note_written(e.dz); }
    void note(const event::AelDrop& e) {
        for (std::size_t i = 0; i < e.edges.size(); ++i) note_change();
    }
    void note(const event::Pixel& e) {
        ++counts_[(e.shown ? "pixels written of " : "pixels rejected of ") + polygon_];
        note_tie(e.z, e.stored);
        note_written(e.z);
    }
    void note(const auto&) {}

    void note_written(const Value& value) { long_numbers_ += is_short(value.number) ? 0 : 1; }

    void note_change() { ++counts_["changes of the AEL of " + polygon_]; }

    /// The filter's approximations of one depth may be some ulps apart; two depths on a coarse lattice are farther.
    void note_tie(const Value& z, const Value& against) {
        constexpr double some_ulps = 0x1p-42;
        ties_ = ties_ || (std::isfinite(against.number) && std::abs(z.number - against.number) <= some_ulps);
    }

    const Scene& scene_;
    std::set<Line> lines_;
    std::map<std::string, std::uint64_t> counts_;
    bool on_a_line_ = false, ties_ = false;
    std::uint64_t long_numbers_ = 0;
    double root_side_ = 0;
    int level_ = 0;
    std::string polygon_;
};

std::uint64_t sum_of(const Profile& profile) {
    std::uint64_t sum = 0;
    for (const auto& [what, count] : profile.counts) sum += count;
    return sum;
}

/// Whether two counts differ by at most 1/`part` of the second, rounded up.
bool is_about(std::uint64_t count, std::uint64_t other, std::uint64_t part) {
    const std::uint64_t difference = count > other ? count - other : other - count;
    return difference <= (other + part - 1) / part;
}

}  // namespace

ProfiledRun profiled_run(const AdmittedScene& scene, Method method) {
    Profiler profiler(scene);
    Picture picture =
        run({method, kernel_of(KernelKind::filtered), Edition::corrected, scene, Detail::signs, &profiler});
    return {profiler.profile(picture), std::move(picture), profiler.long_numbers()};
}

bool is_short(double number) {
    constexpr int greatest = 99;
    constexpr double rounding = 0x1p-30;  // fractions on the lattices of exercises are farther from the short ones
    for (int denominator = 1; denominator <= greatest; ++denominator) {
        const double numerator = number * denominator;
        if (std::abs(numerator) < greatest + 0.5 && std::abs(numerator - std::round(numerator)) < rounding) return true;
    }
    return false;
}

bool is_as_hard(const Profile& profile, const Profile& as) {
    constexpr std::uint64_t of_a_count = 10, of_the_sum = 20;
    if (profile.met != as.met || profile.counts.size() != as.counts.size()) return false;
    const bool counts_agree = std::equal(
        profile.counts.begin(), profile.counts.end(), as.counts.begin(), [&](const auto& one, const auto& other) {
            return one.first == other.first && is_about(one.second, other.second, of_a_count);
        });
    return counts_agree && is_about(sum_of(profile), sum_of(as), of_the_sum);
}

}  // namespace vidno
