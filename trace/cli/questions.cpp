#include "commands.h"
#include "output.h"
#include "page.h"
#include "program.h"

namespace vidno::cli {

std::string moodle_questions(const std::string& trace, const std::string& language, int count) {
    const std::vector<std::string> command = {"node",   questions_script(), "--language",
                                              language, "--count",          std::to_string(count)};
    const std::string bytes = read_file(trace);
    try {
        return output_of(command, bytes);
    } catch (const Refused& refused) {
        throw Refused(trace + ": " + refused.what());
    }
}

int worksheet(const WorksheetOptions& options) {
    if (!is_trace(options.trace)) throw Refused(options.trace + ": not .jsonl or .jsonl.gz");
    if (options.output != "-" && !options.output.ends_with(".xml")) throw Refused(options.output + ": not .xml");
    OutputFile output(options.output);
    TraceReader reader(LineReader(options.trace), options.trace);
    while (reader.next()) {
    }
    output.write(moodle_questions(options.trace, options.language, options.count));
    output.commit();
    return is_whole(reader) ? 0 : 1;
}

}  // namespace vidno::cli
