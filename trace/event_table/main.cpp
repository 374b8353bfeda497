// Writes what follows from the table of events:
//
//     vidno_event_table page LISTINGS FOLDER   the page's table of events, and its choices
//     vidno_event_table documents ROOT         the derived parts of FORMAT.md and of the schema

#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "choice/choices_json.h"
#include "event_table/event_table.h"

namespace {

std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace

int main(int count, char** words) try {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() == 3 && arguments[0] == "page") {
        write(arguments[2] + "/event-table.ts", vidno::event_types(content(arguments[1])));
        write(arguments[2] + "/choices.json", vidno::choices_json());
    } else if (arguments.size() == 2 && arguments[0] == "documents") {
        const std::string format = arguments[1] + "/trace/FORMAT.md";
        const std::string schema = arguments[1] + "/trace/schema/trace.schema.json";
        write(format, vidno::with_event_tables(content(format)));
        write(schema, vidno::with_event_schema(content(schema)));
    } else {
        throw std::runtime_error("page LISTINGS FOLDER, or documents ROOT");
    }
} catch (const std::exception& error) {
    std::cerr << "vidno_event_table: " << error.what() << '\n';
    return 1;
}
