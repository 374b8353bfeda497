/// Page: the built pages that come with the program.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "choice/language.h"

namespace vidno {

/// A trace, or a scene that the page runs when it is opened.
struct PageFile {
    std::string title;
    std::string method, kernel, edition, detail;  // of the run
    std::string bytes;                            // a trace, gzipped; or a scene
    bool is_scene = false;
};

/// The contents of a page: an index, like that of a course, and the files that it names.
struct PageContent {
    nlohmann::ordered_json index = nlohmann::ordered_json::array();
    std::vector<std::pair<std::string, std::string>> files;  // a trace or a story is gzipped
    bool has_scene = false;

    void add(const PageFile& file);

    /// The title of the first entry, and of the last if there are several; the program's name if there is none.
    std::string title(Language language) const;
};

/// The page that shows traces, with this content instead of its lessons, if there is any. It opens in the language, or
/// else in the one that the browser prefers. Throws Refused if no page was built, or if it cannot run a scene.
std::string trace_page(const PageContent& content, std::optional<Language> language = std::nullopt);

/// The address under which a browser opens a file of this machine. The path is absolute.
std::string file_address(const std::filesystem::path& path);

/// The page that shows a chart, with the chart and, if it was built, the address of the page that replays its runs.
/// Throws Refused if no page was built.
std::string chart_page(const std::string& json);

/// The path of the script for Node that asks about a trace. Throws Refused if it was not built.
std::string questions_script();

}  // namespace vidno
