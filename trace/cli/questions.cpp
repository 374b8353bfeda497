#include "commands.h"
#include "output.h"
#include "page/page.h"
#include "page/program.h"

namespace vidno::cli {

namespace {

/// What the page's own code asks about a trace, as Moodle XML.
std::string asked_about(const std::string& trace, const WorksheetOptions& options) {
    const std::string count = std::to_string(options.count.value_or(20));
    const std::string bytes = read_file(trace);
    try {
        return output_of({"node", questions_script(), "--language", options.language, "--count", count}, bytes);
    } catch (const Refused& refused) {
        throw Refused(trace + ": " + refused.what());
    }
}

}  // namespace

int moodle_questions(const WorksheetOptions& options) {
    if (options.files.size() > 1) throw Refused(options.files[1] + ": .xml has the questions of one trace");
    if (options.method || options.key) throw Refused("--method, --key: of sheets, which are .pdf");
    const std::string& trace = options.files[0];
    if (!is_trace(trace)) throw Refused(trace + ": not .jsonl or .jsonl.gz");
    TraceReader reader(LineReader(trace), trace);
    while (reader.next()) {
    }
    write_file(options.output, asked_about(trace, options));
    return is_whole(reader) ? 0 : 1;
}

}  // namespace vidno::cli
