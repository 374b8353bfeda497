#include "stability/shrink.h"

#include <iostream>

#include "check/check.h"
#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct ShrinkOptions : RunOptions {
    std::string output, keep = "failure";
    std::string at;  // the label of a line, for "decision"
};

/// Runs each scene that shrinking tries.
class Trial {
public:
    explicit Trial(const RunOptions& options)
        : kernel_(kernel_of(options)), method_(method_of(options)), edition_(edition_of(options)) {}

    RunRequest request(const AdmittedScene& scene) const { return {method_, kernel_, edition_, scene, Detail::signs}; }
    bool admits(const AdmittedScene& scene) const { return !refusal_of(method_, scene); }
    Picture picture(const AdmittedScene& scene) const { return run(request(scene)); }
    CheckReport check(const AdmittedScene& scene) const {
        return check_run(request(scene), right_picture(scene, method_));
    }

    bool wrong_picture(const AdmittedScene& scene) const {
        return picture(scene) !=
               run({reference_of(method_), kernel_of(KernelKind::filtered), Edition::corrected, scene});
    }
    bool reaches(const std::string& label, const AdmittedScene& scene) const {
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

/// The procedure of the first wrong decision.
std::optional<Procedure> first_wrong(const CheckReport& report) {
    std::optional<Procedure> procedure;
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    for (const auto& each : report.procedures) {
        if (!each.first() || *each.first() >= first) continue;
        first = *each.first();
        procedure = each.procedure;
    }
    return procedure;
}

/// The property that the options ask to keep; the scene must have it.
Property property_of(const ShrinkOptions& options, const Trial& trial, const AdmittedScene& scene) {
    if (options.keep == "picture") {
        return [&trial, right = trial.picture(scene)](const AdmittedScene& smaller) {
            return trial.picture(smaller) == right;
        };
    }
    if (options.keep == "decision") {
        Property reaches = [&](const AdmittedScene& smaller) { return trial.reaches(options.at, smaller); };
        if (reaches(scene)) return reaches;
        throw Refused(options.scene + ": the run has no step at " + options.at);
    }
    if (trial.wrong_picture(scene)) return [&](const AdmittedScene& smaller) { return trial.wrong_picture(smaller); };
    if (const auto procedure = first_wrong(trial.check(scene))) {
        return [&, wrong = *procedure](const AdmittedScene& smaller) {
            return first_wrong(trial.check(smaller)) == wrong;
        };
    }
    throw Refused(options.scene + ": nothing fails: no decision and no pixel is wrong");
}

int shrink(ShrinkOptions options) {
    if ((options.keep == "decision") == options.at.empty()) throw Refused("--keep decision and --at go together");
    const AnyScene given = any_scene_for(options);
    const auto* polygons = std::get_if<AdmittedScene>(&given);
    if (!polygons)
        throw Refused(options.scene + ": a surface, but this command takes scenes of polygons, vidno-scene/1");
    const Trial trial(options);
    const AdmittedScene scene = scene_for(kernel_of(options), *polygons, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    OutputFile file(options.output);
    Progress progress("scenes tried");
    const Property keeps = property_of(options, trial, scene);
    const AdmittedScene smallest = shrunk(scene, [&, tried = 0ULL](const AdmittedScene& smaller) mutable {
        progress.show(++tried);
        return trial.admits(smaller) && keeps(smaller);
    });
    file.write(scene_json(smallest) + '\n');
    file.commit();
    progress.clear();
    std::cerr << options.scene << ": " << smallest->polygons.size() << " of " << scene->polygons.size() << " polygons, "
              << vertices_of(smallest) << " of " << vertices_of(scene) << " vertices\n";
    return 0;
}

}  // namespace

void add_shrink(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("shrink", "Find the smallest scene that still fails or still behaves in a given way");
    const auto options = std::make_shared<ShrinkOptions>();
    add_run_options(command, *options, "A scene file, vidno-scene/1, or a failure; - for standard input",
                    "The algorithm [warnock]", words(method_names));
    auto* keep =
        command.add_option("--keep", options->keep,
                           "failure: a wrong pixel or, if there is none, a wrong decision of the same procedure; "
                           "picture: the picture that this run paints; decision: a step at the line --at LINE");
    keep->check(CLI::IsMember({"failure", "picture", "decision"}))->capture_default_str();
    command.add_option("--at", options->at, "A line of the listing, such as PL5 or W13")
        ->check(CLI::IsMember(words(line_names)));
    command.add_option("-o", options->output, "The scene, .json; - for standard output")->required();
    command.footer(
        "The result would lose the property if it lost another polygon, vertex or binary place of a coordinate.\n"
        "Example: vidno shrink scene.json --kernel float --keep failure -o smallest.json");
    command.callback([options, &status] { status = shrink(*options); });
}

}  // namespace vidno::cli
