#include "figure/worksheet.h"

#include "commands.h"
#include "figure/writers.h"
#include "output.h"
#include "progress.h"

namespace vidno::cli {

namespace {

using figures::Language;

void expect_pdf(const std::string& name) {
    if (!name.ends_with(".pdf")) throw Refused(name + ": not .pdf or .xml");
}

/// Scenes one after the other, each on pages of its own.
class Sheets {
public:
    Sheets(bool answered, Language language) : answered_(answered), language_(language) {}

    void add(const figures::WorkedRun& run) {
        const figures::About about{run.scene().name, language_};
        if (pages_.empty()) about_ = about;
        for (const auto& page : figures::worksheet(run, language_, answered_)) {
            pages_.push_back(figures::svg_of(page, about));
        }
    }
    std::string pdf() const { return figures::pdf_of(pages_, about_); }

private:
    bool answered_;
    Language language_;
    figures::About about_{};
    std::vector<std::string> pages_;
};

}  // namespace

int worksheet(const WorksheetOptions& options) {
    if (options.output.ends_with(".xml")) return moodle_questions(options);
    expect_pdf(options.output);
    if (options.key) expect_pdf(*options.key);
    if (options.key == options.output) throw Refused("--key " + *options.key + ": that is the blank sheets' file");
    if (options.count) throw Refused("--count: " + options.output + " has sheets, no questions");
    const auto language = Language(place_in(figures::language_codes, options.language));
    const auto method = Method(place_in(method_names, options.method.value_or("warnock")));
    Sheets blank(false, language), key(true, language);
    Progress progress("scenes");
    for (std::size_t i = 0; i < options.files.size(); ++i) {
        const Scene scene = scene_from(options.files[i]);
        figures::expect_room(scene, options.files[i]);
        const figures::WorkedRun run(scene, method);
        blank.add(run);
        if (options.key) key.add(run);
        progress.show(i + 1, options.files.size());
    }
    progress.clear();
    if (options.key) write_file(*options.key, key.pdf());
    write_file(options.output, blank.pdf());
    return 0;
}

}  // namespace vidno::cli
