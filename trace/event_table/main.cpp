// Writes the files derived from the tables of events and choices:
//
//     vidno_event_table page LISTINGS FAILURES FOLDER
//         the page's table of events, its choices, what it says of other formats, the names of scenes, and the
//         witnesses of deviations
//     vidno_event_table documents TRACE
//         the derived parts of FORMAT.md and of the schemas, in the folder trace/

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "choice/choices_json.h"
#include "event_table/event_table.h"
#include "output.h"

int main(int count, char** words) try {
    using namespace vidno;
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() == 4 && arguments[0] == "page") {
        write_file(arguments[3] + "/event-table.ts", page_types(read_file(arguments[1])));
        write_file(arguments[3] + "/choices.json", choices_json());
        write_file(arguments[3] + "/format-words.json", format_words_json());
        write_file(arguments[3] + "/scene-names.json", scene_names_json());
        write_file(arguments[3] + "/witnesses.json", witnesses_json([&](std::string_view witness) {
                       return read_file(arguments[2] + "/" + std::string(witness) + ".json");
                   }));
    } else if (arguments.size() == 2 && arguments[0] == "documents") {
        for (const auto& [name, derived] : derived_documents()) {
            const std::string file = arguments[1] + "/" + std::string(name);
            write_file(file, derived(read_file(file)));
        }
    } else {
        throw std::runtime_error("page LISTINGS FAILURES FOLDER, or documents TRACE");
    }
} catch (const std::exception& error) {
    std::cerr << "vidno_event_table: " << error.what() << '\n';
    return 1;
}
