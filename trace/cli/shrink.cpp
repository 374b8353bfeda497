#include "stability/shrink.h"

#include <iomanip>
#include <iostream>

#include "check/check.h"
#include "choice/method.h"
#include "commands.h"
#include "output.h"
#include "progress.h"
#include "scene/scene_json.h"
#include "stability/need.h"

namespace vidno::cli {

namespace {

/// A run of each scene that shrinking tries.
class Trial {
public:
    explicit Trial(const RunOptions& options)
        : kernel_(kernel_of(options)), method_(method_of(options)), edition_(edition_of(options)) {}

    RunRequest request(const Scene& scene) const { return {method_, kernel_, edition_, scene, Detail::signs}; }
    bool admits(const Scene& scene) const { return !refusal_of(method_, scene); }
    Picture picture(const Scene& scene) const { return run(request(scene)); }
    CheckReport check(const Scene& scene) const { return check_run(request(scene), right_picture(scene, method_)); }

    bool wrong_picture(const Scene& scene) const {
        return picture(scene) != run({reference_of(method_), *kernel_named("filtered"), Edition::corrected, scene});
    }
    bool reaches(const std::string& label, const Scene& scene) const {
        std::string text;
        TraceWriter writer({method_, edition_, kernel_.name(), Detail::signs, scene},
                           [&](std::string_view part) { text += part; });
        RunRequest traced = request(scene);
        traced.sink = &writer;
        writer.finish(run(traced));
        return text.find("\"at\":\"" + label + '"') != std::string::npos;
    }

private:
    NamedKernel kernel_;
    Method method_;
    Edition edition_;
};

/// The procedure that is the first to decide wrongly.
std::optional<Procedure> first_wrong(const CheckReport& report) {
    std::optional<Procedure> procedure;
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    for (const auto& each : report.procedures) {
        if (!each.first_wrong || *each.first_wrong >= first) continue;
        first = *each.first_wrong;
        procedure = each.procedure;
    }
    return procedure;
}

/// What the options say is to be kept; the scene must have it.
Property property_of(const ShrinkOptions& options, const Trial& trial, const Scene& scene) {
    if (options.keep == "picture") {
        return [&trial, right = trial.picture(scene)](const Scene& smaller) { return trial.picture(smaller) == right; };
    }
    if (options.keep == "decision") {
        Property reaches = [&](const Scene& smaller) { return trial.reaches(options.at, smaller); };
        if (reaches(scene)) return reaches;
        throw Refused(options.run.scene + ": the run has no step at " + options.at);
    }
    if (trial.wrong_picture(scene)) return [&](const Scene& smaller) { return trial.wrong_picture(smaller); };
    if (const auto procedure = first_wrong(trial.check(scene))) {
        return [&, wrong = *procedure](const Scene& smaller) { return first_wrong(trial.check(smaller)) == wrong; };
    }
    throw Refused(options.run.scene + ": nothing fails: no decision is wrong, and no pixel");
}

}  // namespace

int shrink(const ShrinkOptions& options) {
    if ((options.keep == "decision") == options.at.empty()) throw Refused("--keep decision and --at go together");
    const Trial trial(options.run);
    const Scene scene = scene_for(kernel_of(options.run), scene_from(options.run.scene), options.run.scene);
    expect_admitted(method_of(options.run), scene, options.run.scene);
    OutputFile file(options.run.output);
    Progress progress("scenes tried");
    const Property keeps = property_of(options, trial, scene);
    const Scene smallest = shrunk(scene, [&, tried = 0ULL](const Scene& smaller) mutable {
        progress.show(++tried);
        return trial.admits(smaller) && keeps(smaller);
    });
    file.write(scene_json(smallest) + '\n');
    file.commit();
    progress.clear();
    std::cerr << options.run.scene << ": " << smallest.polygons.size() << " of " << scene.polygons.size()
              << " polygons, " << vertices_of(smallest) << " of " << vertices_of(scene) << " vertices\n";
    return 0;
}

int need(const NeedOptions& options) {
    const Scene scene = scene_from(options.scene);
    Progress progress("pictures");
    const NeedReport report = needs_of(scene, [&, pictures = 0ULL]() mutable { progress.show(++pictures); });
    progress.clear();
    if (!options.output.empty()) {
        OutputFile file(options.output);
        file.write(scene_json(report.least) + '\n');
        file.commit();
    }
    std::cout << std::left << std::setw(32) << "the picture needs" << std::setw(14) << ""
              << "one less\n";
    for (const auto& [what, amount, one_lower] : report.needs) {
        std::cout << std::setw(32) << what << std::setw(14) << amount << (one_lower.empty() ? "-" : one_lower) << '\n';
    }
    return 0;
}

}  // namespace vidno::cli
