/// Page: the built pages that come with the program.
#pragma once

#include <string>
#include <vector>

namespace vidno {

/// What a page of traces has beside each other: a trace, or a scene that it runs when it is opened.
struct PageFile {
    std::string title;
    std::string method, kernel, edition, detail;  // of the run
    std::string bytes;                            // a trace, gzipped; or a scene
    bool is_scene = false;
};

/// The page that shows traces, with these files instead of its lessons, or, if there are none, with the lessons. Throws
/// Refused if no page was built, or if it cannot run a scene.
std::string trace_page(const std::vector<PageFile>& files);

/// The page that shows a chart, with the chart in it and, if it was built, the address of the page that replays its runs.
/// Throws Refused if no page was built.
std::string chart_page(const std::string& json);

/// Where the script for Node is that asks about a trace. Throws Refused if it was not built.
std::string questions_script();

}  // namespace vidno
