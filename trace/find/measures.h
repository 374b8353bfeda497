/// Measures: the values of a condition's names for a scene and its run.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "find/condition.h"
#include "format/event_sink.h"
#include "scene/surface.h"

namespace vidno {

/// Counts what a run does, step by step. It hears each event of level `signs`.
class RunCounts {
public:
    void hear(const EventView& event);

    std::uint64_t reached(Line line) const { return reached_[std::size_t(line)]; }
    std::uint64_t windows() const { return windows_; }
    std::uint64_t splits() const { return splits_; }
    std::uint64_t events() const { return events_; }
    std::uint64_t depth_of_stack() const { return deepest_; }

    /// A quantity that grows.
    double of(const Name& name) const;

private:
    /// Where a procedure is, and the kind of step with which it came there. When this kind comes again, the line begins
    /// again.
    struct Frame {
        Line at{};
        std::size_t began = 0;
    };

    void come_to(Line line, std::size_t kind);

    std::array<std::uint64_t, line_names.size()> reached_{};
    std::uint64_t windows_ = 0, splits_ = 0, events_ = 0, stack_ = 0, deepest_ = 0;
    std::vector<Frame> frames_{{}};
};

/// A quantity that needs no run.
double of_scene(const Name& name, const Scene& scene);
double of_scene(const Name& name, const CurveScene& scene);

// Methods have the names of the command line: those of Method, and `floating-horizon` for curves.

/// Throws Refused if a name does not suit a run of the method: it has no such line or quantity, or the kernel of
/// `wrong` does not run it.
void expect_suits(const Condition& condition, std::string_view method);

/// The first method that suits the condition, Warnock's if it can be. Throws Refused if none does.
std::string_view method_for(const Condition& condition);

/// The values of the condition's names, in their order. The method must suit the condition and take the scene. The
/// kernel must be one that is always right and does not snap: `filtered` or `exact`.
std::vector<double> measured(const Condition& condition, const AdmittedScene& scene, Method method,
                             const NamedKernel& kernel);
/// Those of curves, which the floating horizon draws.
std::vector<double> measured(const Condition& condition, const AdmittedCurves& scene, const NamedKernel& kernel);
/// Those of either; the method is for curves if the scene is.
std::vector<double> measured(const Condition& condition, const AnyScene& scene, std::string_view method,
                             const NamedKernel& kernel);

/// The text of a line in a listing, in English.
std::string text_of(Line line);

/// The methods in whose listings the line is, by name; also that of curves.
std::vector<std::string> methods_with(Line line);

}  // namespace vidno
